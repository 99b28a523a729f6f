// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/fillingModel/ModelFile.hpp"
#include "FillingTables.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

using namespace interstice;
using namespace interstice::test;

namespace
{

/// A file of this test alone, removed with it.
class ModelFile : public testing::Test
{
protected:
    ModelFile()
        : file(testing::TempDir() + "ModelFileTest."
               + testing::UnitTest::GetInstance()->current_test_info()->name() + ".json")
    {
    }

    ~ModelFile() override { std::remove(file.c_str()); }

    std::string written() const
    {
        std::ifstream in(file);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }

    void overwrite(const std::string& text) const { std::ofstream(file) << text; }

    std::string messageOnReading() const
    {
        return messageOf([&] { readModel(file); });
    }

    const std::string file;
    const FillingModel model = fitFillingModel(
        syntheticTable([](const DieFilling& filling)
            { return fillingByEq21(filling) + 0.01 * std::sin(1e6 * filling.shoeSpeed); },
            0.01),
        0.9)
                                   .model;
};

void expectSame(const Plane& a, const Plane& b)
{
    EXPECT_EQ(a.fit.names, b.fit.names);
    EXPECT_EQ(a.fit.coefficients, b.fit.coefficients);
    EXPECT_EQ(a.fit.covariance, b.fit.covariance);
    EXPECT_EQ(a.fit.points, b.fit.points);
    EXPECT_EQ(a.fit.weighted, b.fit.weighted);
    EXPECT_EQ(a.fit.rSquared, b.fit.rSquared);
    EXPECT_EQ(a.fit.chiSquare, b.fit.chiSquare);
    EXPECT_EQ(a.fit.scatter, b.fit.scatter);
    EXPECT_EQ(a.largestError, b.largestError);
    for (std::size_t i = 0; i < rangedCount; ++i)
    {
        EXPECT_EQ(a.range[i].low, b.range[i].low);
        EXPECT_EQ(a.range[i].high, b.range[i].high);
    }
}

} // namespace

TEST_F(ModelFile, ComesBackToTheLastBit)
{
    writeModel(model, file);
    const FillingModel back = readModel(file);

    EXPECT_EQ(back.table, model.table);
    EXPECT_EQ(back.measure, model.measure);
    EXPECT_EQ(back.threshold, model.threshold);
    expectSame(back.criticalSize, model.criticalSize);
    ASSERT_TRUE(back.fillingRatio);
    expectSame(*back.fillingRatio, *model.fillingRatio);
    ASSERT_EQ(back.series.size(), model.series.size());
    for (std::size_t i = 0; i < back.series.size(); ++i)
    {
        EXPECT_EQ(back.series[i].value, model.series[i].value);
        EXPECT_EQ(back.series[i].error, model.series[i].error);
        EXPECT_EQ(back.series[i].packings, model.series[i].packings);
        EXPECT_EQ(
            back.series[i].filling.particleDiameter, model.series[i].filling.particleDiameter);
        EXPECT_EQ(back.series[i].filling.gasViscosity, model.series[i].filling.gasViscosity);
    }
}

TEST_F(ModelFile, MayBeWithoutAFillingRatioAndWithoutErrors)
{
    FillingModel poorer = model;
    poorer.fillingRatio.reset();
    poorer.series[0].error.reset();
    writeModel(poorer, file);
    EXPECT_FALSE(readModel(file).fillingRatio);
    EXPECT_FALSE(readModel(file).series[0].error);
}

// Cut anywhere, it is one clear error, and no other exception.
TEST_F(ModelFile, RefusesATruncatedFile)
{
    writeModel(model, file);
    const std::string whole = written();
    for (std::size_t length = 0; length + 3 < whole.size(); length += 97)
    {
        overwrite(whole.substr(0, length));
        expectSays(messageOnReading(), {"not a whole filling model", file, "Write it again."});
    }
}

// Every key is needed: without any one of them it is no model.
TEST_F(ModelFile, RefusesAFileWithoutOneOfItsKeys)
{
    writeModel(model, file);
    const nlohmann::json whole = nlohmann::json::parse(written());
    for (const auto& item : whole.items())
    {
        nlohmann::json less = whole;
        less.erase(item.key());
        overwrite(less.dump());
        if (item.key() != "program")
        {
            expectSays(messageOnReading(), {"not a whole filling model", file});
        }
    }
}

TEST_F(ModelFile, RefusesNumbersThatAreNoModel)
{
    writeModel(model, file);
    const nlohmann::json whole = nlohmann::json::parse(written());
    const auto expectRefused =
        [&](const char* pointer, const nlohmann::json& value, const char* says)
    {
        nlohmann::json other = whole;
        other[nlohmann::json::json_pointer(pointer)] = value;
        overwrite(other.dump());
        expectSays(messageOnReading(), {"not a whole filling model", says});
    };
    expectRefused("/format", "something else", "another kind of file");
    expectRefused("/formatVersion", 2, "another version");
    expectRefused("/threshold", 90, "threshold");
    expectRefused("/criticalSize/coefficients", {1, 2}, "coefficients are not as many");
    expectRefused("/criticalSize/coefficients/1", "x", "must be number");
    expectRefused("/criticalSize/covariance/1", {1, 2}, "not square");
    expectRefused("/criticalSize/covariance/1/1", -1, "negative variance");
    expectRefused("/criticalSize/points", 3, "points are not more");
    expectRefused("/criticalSize/names", {"N_v", "other"}, "names of a plane");
    expectRefused("/criticalSize/range/N_v", {2, 1}, "ends before");
    expectRefused("/series/0/dieDepth", 0, "not positive");
}

TEST_F(ModelFile, RefusesAMissingFileAndAFolderThatIsNotThere)
{
    expectSays(messageOf([] { readModel("/no/such/model.json"); }), {"cannot be opened"});
    expectSays(messageOf([&] { writeModel(model, "/no/such/model.json"); }),
        {"cannot be written", "/no/such/model.json"});
}
