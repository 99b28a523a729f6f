// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solvers/fillingModel/FillingModel.hpp"
#include "solvers/fillingModel/ResultsTable.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace interstice::test
{

/// The die and the air of the published study, with another powder and speed.
inline DieFilling studyDie(double diameter, double density, double speed)
{
    return {diameter, density, 1.225, 1.7894e-5, 9.81, speed, 8e-3, 5e-3};
}

/// What a synthetic run measures: filling ratio and its standard error.
using Measure = std::function<double(const DieFilling&)>;

/// Three speeds, three densities, `sizes` diameters from 20 um on in steps of 10 um.
inline ResultsTable syntheticTable(
    const Measure& measure, std::optional<double> error, int sizes = 9)
{
    ResultsTable table{"synthetic.csv", "fillingRatioPassed", {}, 0, error.has_value()};
    for (const double density : {5360., 7360., 9360.})
    {
        for (const double speed : {0.1, 0.125, 0.15})
        {
            for (int i = 0; i < sizes; ++i)
            {
                const DieFilling filling = studyDie(20e-6 + 10e-6 * i, density, speed);
                const int line = static_cast<int>(table.variants.size()) + 2;
                table.variants.push_back({filling, measure(filling), error, 20, line});
            }
        }
    }
    return table;
}

/// Filling ratio 0.9 at the critical size of Eq 21, and a straight line through it.
inline double fillingByEq21(const DieFilling& filling)
{
    return 0.9 + 60 * (sizeRatio(filling) - sizeRatioFor90Percent(filling));
}

/// The message of the InputError that `act` throws; empty if it throws none.
inline std::string messageOf(const std::function<void()>& act)
{
    try
    {
        act();
    }
    catch (const InputError& error)
    {
        return error.what();
    }
    return "";
}

/// The message names all of these.
inline void expectSays(const std::string& message, const std::vector<std::string>& parts)
{
    for (const std::string& part : parts)
    {
        EXPECT_NE(message.find(part), std::string::npos) << '"' << part << "\" in\n" << message;
    }
}

} // namespace interstice::test
