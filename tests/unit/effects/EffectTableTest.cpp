// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/effects/EffectTable.hpp"
#include "coupling/laws/InputError.hpp"

#include <gtest/gtest.h>

using namespace interstice;

namespace
{

EffectTable lift(Effect::Wish wish)
{
    Effect effect;
    effect.key = "lift";
    effect.number = "lift over drag";
    effect.limit = 0.1;
    effect.wish = wish;
    EffectTable table;
    table.add(effect);
    return table;
}

} // namespace

TEST(EffectTable, ANumberAboveItsLimitTurnsAnEffectOnForGood)
{
    EffectTable table = lift(Effect::Wish::automatic);
    EXPECT_EQ(table.meet(0, 0.1, 1.0), "");
    EXPECT_FALSE(table.on(0));
    EXPECT_EQ(table.meet(0, 0.125, 2.0),
        "lift is simulated from 2 s on: lift over drag is 0.12, above 0.1.");
    EXPECT_TRUE(table.on(0));
    EXPECT_EQ(table.meet(0, 0.01, 3.0), "");
    EXPECT_TRUE(table.on(0));
    EXPECT_EQ(table.effects()[0].largest, 0.125);
    EXPECT_EQ(table.effects()[0].since, 2.0);
}

TEST(EffectTable, AUserWhoIsWrongIsToldOnceAndObeyed)
{
    EffectTable table = lift(Effect::Wish::off);
    EXPECT_EQ(table.meet(0, 0.2, 1.0), "lift is off, and would matter: lift over drag is 0.2, above 0.1.");
    EXPECT_EQ(table.meet(0, 0.3, 2.0), "");
    EXPECT_FALSE(table.on(0));
}

TEST(EffectTable, AnEffectMayBeOnAndMissingSomewhere)
{
    EffectTable table;
    table.add({"walls", "speed of an unseen one", 0.1, Effect::Wish::off, {}, true});
    EXPECT_EQ(table.meet(0, 0.2, 1.0),
        "walls is not simulated everywhere, and would matter: speed of an unseen one is 0.2, above 0.1.");
    EXPECT_TRUE(table.on(0));
}

TEST(EffectTable, AUsersEffectIsOnFromTheStart)
{
    EffectTable table = lift(Effect::Wish::on);
    EXPECT_TRUE(table.on(0));
    EXPECT_EQ(table.meet(0, 0.2, 1.0), "");
}

TEST(EffectTable, TellsWhoDecidedByWhichNumber)
{
    EffectTable table = lift(Effect::Wish::automatic);
    table.meet(0, 0.05, 0);
    EXPECT_EQ(table.text(),
        "    effect                  by         number   limit\n"
        "    lift             off    number       0.05     0.1   lift over drag\n");
}

TEST(EffectTable, TellsWhatShareOfTheTimeAnEffectCost)
{
    EffectTable table = lift(Effect::Wish::on);
    table.spend(table.place("lift"), 0.25);
    table.spend(0, 0.5);
    EXPECT_EQ(table.text(60),
        "    effect                  by         number   limit      time\n"
        "    lift             on     user            -     0.1    1.25 %   lift over drag\n");
    {
        const EffectTable::Timed timed(table, 0);
    }
    EXPECT_GT(table.effects()[0].seconds, 0.75);
    EXPECT_LT(table.effects()[0].seconds, 1);
}

TEST(EffectTable, KnowsThreeWords)
{
    EXPECT_EQ(EffectTable::wish("auto", ""), Effect::Wish::automatic);
    EXPECT_EQ(EffectTable::wish("on", ""), Effect::Wish::on);
    EXPECT_EQ(EffectTable::wish("off", ""), Effect::Wish::off);
    EXPECT_THROW(EffectTable::wish("yes", ""), InputError);
}
