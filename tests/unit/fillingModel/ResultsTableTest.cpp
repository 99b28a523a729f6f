// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillingTables.hpp"

#include <sstream>

using namespace interstice;
using namespace interstice::test;

namespace
{

const std::string header = "status,particleDiameter,particleDensity,shoeSpeed,dieLength,dieDepth,"
                           "airDensity,airViscosity,fillingRatioPassed,fillingRatioPassed.error,"
                           "packings\n";
const std::string row = "ok,40e-6,7360,0.15,8e-3,5e-3,1.225,1.7894e-5,0.65,0.01,3\n";

ResultsTable read(const std::string& text, const std::string& measure = "fillingRatioPassed")
{
    std::istringstream in(text);
    return readResults(in, "runs.csv", measure);
}

std::string messageFor(const std::string& text, const std::string& measure = "fillingRatioPassed")
{
    return messageOf([&] { read(text, measure); });
}

std::string replaced(std::string text, const std::string& old, const std::string& by)
{
    return text.replace(text.find(old), old.size(), by);
}

} // namespace

TEST(ResultsTable, ReadsARow)
{
    const ResultsTable table = read(header + row);

    ASSERT_EQ(table.variants.size(), 1u);
    const Variant& variant = table.variants[0];
    EXPECT_EQ(variant.filling.particleDiameter, 40e-6);
    EXPECT_EQ(variant.filling.particleDensity, 7360);
    EXPECT_EQ(variant.filling.shoeSpeed, 0.15);
    EXPECT_EQ(variant.filling.dieLength, 8e-3);
    EXPECT_EQ(variant.filling.dieDepth, 5e-3);
    EXPECT_EQ(variant.filling.gasDensity, 1.225);
    EXPECT_EQ(variant.filling.gasViscosity, 1.7894e-5);
    EXPECT_EQ(variant.measure, 0.65);
    EXPECT_EQ(variant.error, 0.01);
    EXPECT_EQ(variant.packings, 3);
    EXPECT_EQ(variant.line, 2);
}

TEST(ResultsTable, TakesColumnsInAnyOrderAndIgnoresOthers)
{
    const ResultsTable table =
        read("note,dieDepth,fillingRatio,airViscosity,airDensity,dieLength,"
             "shoeSpeed,particleDensity,particleDiameter\r\n"
             "\"fast, \"\"light\"\"\", 5e-3 ,0.5,2e-5,1.2,8e-3,+0.2,3000,2e-5\r\n",
            "fillingRatio");

    EXPECT_EQ(table.variants.at(0).filling.dieDepth, 5e-3);
    EXPECT_EQ(table.variants.at(0).filling.shoeSpeed, 0.2);
    EXPECT_EQ(table.variants.at(0).measure, 0.5);
    EXPECT_FALSE(table.variants.at(0).error);
    EXPECT_FALSE(table.hasErrors);
}

TEST(ResultsTable, SkipsTheMarkOfSpreadsheetsCommentsAndEmptyLines)
{
    const ResultsTable table =
        read("\xEF\xBB\xBF" + header + "\n# a remark\n" + row + replaced(row, "ok", "failed"));
    EXPECT_EQ(table.variants.at(0).line, 4);
    EXPECT_EQ(table.leftOut, 1);
}

// What a failed run left in its row is not even read.
TEST(ResultsTable, LeavesOutAndCountsRowsThatAreNotOk)
{
    const ResultsTable table = read(header + "failed,40e-6,7360,0.15,8e-3,5e-3,1.225,1,nan,,\n"
                                    + row + replaced(row, "ok", "running"));
    EXPECT_EQ(table.variants.size(), 1u);
    EXPECT_EQ(table.leftOut, 2);
}

TEST(ResultsTable, TakesAnEmptyErrorAsUnknown)
{
    EXPECT_FALSE(read(header + replaced(row, "0.01,", ",")).variants[0].error);
}

TEST(ResultsTable, NamesTheMissingColumnAndTheNearest)
{
    expectSays(messageFor(replaced(header, "shoeSpeed", "shoespeed") + row),
        {"no column shoeSpeed", "Is shoespeed meant?", "runs.csv"});
    expectSays(messageFor(header + row, "fillingRatioPased"),
        {"no column fillingRatioPased", "Is fillingRatioPassed meant?"});
    expectSays(messageFor(replaced(header, "dieDepth", "tiefe") + row),
        {"no column dieDepth", "Add the column", "tiefe"});
}

TEST(ResultsTable, NamesRowAndColumnOfWhatIsNoNumber)
{
    for (const char* const bad : {"nan", "inf", "abc", "0.65x", "", "1e999", "0,65"})
    {
        const std::string field =
            std::string(bad).find(',') == std::string::npos ? bad : '"' + std::string(bad) + '"';
        const std::string message = messageFor(header + row + replaced(row, "0.65", field));
        expectSays(message, {"not a number", "runs.csv, line 3, column fillingRatioPassed",
                                *bad ? bad : "(nothing)"});
    }
    expectSays(messageFor(header + replaced(row, "0.01", "nan")),
        {"not a number", "line 2, column fillingRatioPassed.error"});
}

TEST(ResultsTable, RefusesWhatCannotBe)
{
    expectSays(messageFor(header + replaced(row, "5e-3", "0")),
        {"not positive", "line 2, column dieDepth"});
    expectSays(messageFor(header + replaced(row, "0.15", "-0.15")), {"column shoeSpeed"});
    expectSays(messageFor(header + replaced(row, "0.65", "65")), {"per cent", "65"});
    expectSays(messageFor(header + replaced(row, "0.01", "-0.01")), {"error is negative"});
}

TEST(ResultsTable, RefusesATornRow)
{
    expectSays(messageFor(header + row + "ok,40e-6,73"), {"3 fields", "11 fields", "line 3"});
}

TEST(ResultsTable, RefusesATableWithoutRows)
{
    expectSays(messageFor(""), {"The table is empty", "runs.csv"});
    expectSays(messageFor(header), {"no row to fit", "0 rows"});
    expectSays(
        messageFor(header + replaced(row, "ok", "failed")), {"and 1 whose status is not ok"});
    expectSays(messageOf([] { readResults("/no/such/file.csv", "x"); }),
        {"cannot be opened", "/no/such/file.csv"});
}
