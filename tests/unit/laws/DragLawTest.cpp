// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DragLaw.hpp"
#include "coupling/laws/InputError.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cfenv>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

namespace
{

constexpr int trapped = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW;

std::string messageOf(const std::string& name, const DragOptions& options = {})
{
    try
    {
        makeDragLaw(name, options, "couplingProperties, drag");
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace

// OpenFOAM ends the run at any of these exceptions.
TEST(DragLaw, RaisesNoFloatingPointExceptionWhateverTheFlow)
{
    for (const DragLawEntry& entry : dragLaws())
    {
        const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
        for (int percent = 20; percent <= 100; ++percent)
        {
            for (double re = 1e-12; re < 2e6; re *= 10)
            {
                const LocalFlow flow = airAt(re, 0.01 * percent);
                std::feclearexcept(FE_ALL_EXCEPT);
                const double b = law->coefficientPerVolume(flow);
                ASSERT_EQ(std::fetestexcept(trapped), 0)
                    << entry.name << ", void fraction " << flow.voidFraction << ", Re " << re;
                ASSERT_TRUE(std::isfinite(b) && b > 0)
                    << entry.name << ", void fraction " << flow.voidFraction << ", Re " << re;
            }
        }
    }
}

TEST(DragLaw, TendsToItsValueAtZeroSlipWithoutAnException)
{
    for (const DragLawEntry& entry : dragLaws())
    {
        const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
        for (const double voidFraction : {0.2, 0.36, 0.6, 0.8, 1.0})
        {
            const LocalFlow still = airAt(0, voidFraction);
            const LocalFlow creeping = airAt(1e-12, voidFraction);
            std::feclearexcept(FE_ALL_EXCEPT);
            const double b = law->coefficientPerVolume(still);
            ASSERT_EQ(std::fetestexcept(trapped), 0) << entry.name << ' ' << voidFraction;
            EXPECT_GT(b, 0) << entry.name;
            EXPECT_NEAR(law->coefficientPerVolume(creeping) / b, 1, 1e-6)
                << entry.name << ' ' << voidFraction;
        }
    }
}

TEST(DragLaw, BearsAVoidFractionThatRoundOffHasLiftedAboveOne)
{
    for (const DragLawEntry& entry : dragLaws())
    {
        const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
        std::feclearexcept(FE_ALL_EXCEPT);
        const double above = law->coefficientPerVolume(airAt(1, 1 + 1e-14));
        EXPECT_EQ(std::fetestexcept(trapped), 0) << entry.name;
        EXPECT_NEAR(above / law->coefficientPerVolume(airAt(1, 1)), 1, 1e-6) << entry.name;
    }
}

TEST(DragLaw, ResistsAFasterSlipMore)
{
    for (const DragLawEntry& entry : dragLaws())
    {
        const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
        for (const double voidFraction : {0.36, 0.5, 0.7, 0.9, 1.0})
        {
            double last = 0;
            for (double re = 1e-6; re < 1e5; re *= 1.5)
            {
                const double force = re * cdRe(*law, airAt(re, voidFraction));
                ASSERT_GT(force, last) << entry.name << ' ' << voidFraction << ' ' << re;
                last = force;
            }
        }
    }
}

TEST(DragLaw, IsMadeByEveryNameOfItsTable)
{
    EXPECT_EQ(dragLaws().size(), 8u);
    EXPECT_EQ(dragLaws().front().name, "GidaspowHuilin");
    for (const DragLawEntry& entry : dragLaws())
    {
        EXPECT_NE(makeDragLaw(entry.name), nullptr) << entry.name;
        EXPECT_FALSE(entry.description.empty()) << entry.name;
        EXPECT_FALSE(entry.reference.empty()) << entry.name;
    }
}

// C_D Re at zero slip and alpha_f = 0.6, by hand from the formula in each law's header; 24 times
// the numbers of Koch-Hill and Beetstra. The two switched laws are one law here.
TEST(DragLaw, IsTheLawThatItsNameSays)
{
    const std::pair<const char*, double> creeping[]{
        {"GidaspowHuilin", 133.0883},
        {"GidaspowSwitch", 133.3333},
        {"ErgunWenYu", 133.3333},
        {"DiFelice", 91.5112},
        {"KochHill", 160.0000},
        {"Beetstra", 170.1020},
        {"SchillerNaumann", 24},
        {"Stokes", 24},
    };
    for (const auto& [name, expected] : creeping)
    {
        EXPECT_NEAR(cdRe(*makeDragLaw(name), airAt(0, 0.6)), expected, 1e-3) << name;
    }

    // 24 (1 + 0.15 x 10^0.687) tells the last two from each other, 0.44 x 995 and
    // 24 (1 + 0.15 x 995^0.687) the switched ones.
    EXPECT_NEAR(cdRe(*makeDragLaw("SchillerNaumann"), airAt(10, 0.6)), 41.5107, 1e-3);
    EXPECT_NEAR(cdRe(*makeDragLaw("GidaspowSwitch"), airAt(995, 1)), 437.8, 1e-3);
    EXPECT_NEAR(cdRe(*makeDragLaw("ErgunWenYu"), airAt(995, 1)), 436.864, 1e-3);
}

TEST(DragLaw, HandsItsOptionsOn)
{
    DragOptions clean;
    clean.cleanBlend = true;
    EXPECT_NEAR(cdRe(*makeDragLaw("GidaspowHuilin", clean), airAt(0, 1)), 24, 1e-9);
}

TEST(DragLaw, NamesTheKnownLawsWhenItIsUnknown)
{
    const std::string message = messageOf("diFelise");
    EXPECT_NE(message.find("diFelise"), std::string::npos) << message;
    EXPECT_NE(message.find("couplingProperties, drag"), std::string::npos) << message;
    EXPECT_NE(message.find("Did you mean DiFelice?"), std::string::npos) << message;
    for (const DragLawEntry& entry : dragLaws())
    {
        EXPECT_NE(message.find(entry.name), std::string::npos) << message;
    }
}

TEST(DragLaw, RefusesASphericityOutsideItsRange)
{
    for (const double sphericity : {0.0, -1.0, 1.01, std::nan("")})
    {
        DragOptions options;
        options.sphericity = sphericity;
        EXPECT_NE(messageOf("Stokes", options).find("sphericity"), std::string::npos);
    }
}
