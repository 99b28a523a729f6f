// SPDX-License-Identifier: GPL-3.0-or-later
#include "Commands.hpp"

#include "CommandLine.hpp"
#include "Inversion.hpp"
#include "LeaveOut.hpp"
#include "ModelFile.hpp"
#include "Parameters.hpp"
#include "Report.hpp"
#include "Text.hpp"

#include <algorithm>
#include <ostream>

namespace interstice
{

namespace
{

constexpr const char* usage = R"(fillingModel: which powder fills a die, from a table of runs

    fillingModel fit TABLE.csv [--measure fillingRatioPassed] [--threshold 0.9]
                               [--leaveOut each|TABLE.csv] [--output MODEL.json]
                               [--trustErrors]
        --trustErrors weighs by the standard errors, though they are from few packings
    fillingModel predict MODEL.json QUANTITIES [--extrapolate]
        the critical size; with --particleDiameter, the filling ratio
    fillingModel invert MODEL.json --for shoeSpeed|particleDiameter|dieDepth QUANTITIES [--extrapolate]
        the largest speed, the smallest particle, the deepest die that is still full
    fillingModel compare MODEL.json
        the published model beside ours

QUANTITIES, in SI units:
)";

std::string usageText()
{
    std::string text = usage;
    for (const Parameter& parameter : parameters)
    {
        text += formatted("    --%-17s %-6s %s", parameter.name, parameter.unit, parameter.meaning);
        text += parameter.usual ? formatted(" (%g unless given)\n", *parameter.usual) : "\n";
    }
    return text
           + "\nEnds with 0, with 1 if the input cannot be used, with 2 if the command line is "
             "not understood.\n";
}

std::vector<std::string> parameterNamesAnd(std::vector<std::string> more)
{
    for (const Parameter& parameter : parameters)
    {
        more.push_back(parameter.name);
    }
    return more;
}

// All parameters but one; that one stays zero.
DieFilling fillingFrom(const CommandLine& line, double DieFilling::*unknown)
{
    DieFilling filling{};
    filling.gravity = 9.81;
    for (const Parameter& parameter : parameters)
    {
        if (parameter.value != unknown)
        {
            filling.*parameter.value = line.positive(parameter.name, parameter.usual);
        }
    }
    return filling;
}

std::string leaveOutReports(const FillingFit& fit, const CommandLine& line)
{
    const FillingModel& model = fit.model;
    const std::string other = line.text("leaveOut", "");
    if (other == "each")
    {
        std::string text = leaveOutReport(PlaneOf::criticalSize,
            leaveOutEach(PlaneOf::criticalSize, fit.criticalPoints, model.table));
        if (model.fillingRatio)
        {
            text += "\n"
                    + leaveOutReport(PlaneOf::fillingRatio,
                        leaveOutEach(PlaneOf::fillingRatio, fit.ratioPoints, model.table));
        }
        return text;
    }

    const ResultsTable table = readResults(other, model.measure);
    const std::vector<Series> series = seriesOf(table);
    std::vector<CriticalSizeRatio> critical;
    for (const Series& one : series)
    {
        critical.push_back(criticalSizeRatio(one, model.threshold));
    }
    const std::vector<PlanePoint> points = criticalPointsOf(critical);
    std::string text = "Table " + other
                       + formatted(": %zu of %zu series have a critical size between two sizes\n",
                           points.size(), series.size());
    text += leaveOutReport(
        PlaneOf::criticalSize, leaveOutTable(PlaneOf::criticalSize, model.criticalSize, points));
    if (model.fillingRatio)
    {
        text +=
            "\n"
            + leaveOutReport(PlaneOf::fillingRatio,
                leaveOutTable(PlaneOf::fillingRatio, *model.fillingRatio, ratioPointsOf(series)));
    }
    return text;
}

Errors errorsOf(const CommandLine& line)
{
    return line.has("trustErrors") ? Errors::trusted : Errors::fromPackings;
}

// What a table says that has no plane of critical sizes: those of its series, and the plane of the filling ratio.
void reportWithoutCriticalSize(const ResultsTable& table, double threshold, Errors errors, std::ostream& out)
{
    FillingFit fit{};
    fit.model.threshold = threshold;
    fit.series = seriesOf(table);
    for (const Series& series : fit.series)
    {
        fit.critical.push_back(criticalSizeRatio(series, threshold));
    }
    fit.ratioPoints = ratioPointsOf(fit.series);
    if (errors == Errors::trusted)
    {
        trustErrors(fit.ratioPoints);
    }
    out << tableReport(table, fit) << '\n' << seriesReport(fit) << '\n';
    const Plane plane = fitPlane(PlaneOf::fillingRatio, fit.ratioPoints, table.file);
    out << planeReport(PlaneOf::fillingRatio, plane)
        << residualReport(PlaneOf::fillingRatio, plane, fit.ratioPoints) << '\n'
        << leaveOutReport(PlaneOf::fillingRatio,
               leaveOutEach(PlaneOf::fillingRatio, fit.ratioPoints, table.file))
        << '\n';
}

FillingFit fitOrReport(const ResultsTable& table, double threshold, Errors errors, std::ostream& out)
{
    try
    {
        return fitFillingModel(table, threshold, errors);
    }
    catch (const InputError& noCriticalSize)
    {
        const InputError kept = noCriticalSize;
        try
        {
            reportWithoutCriticalSize(table, threshold, errors, out);
        }
        catch (const InputError&)
        {
            // Nor that one: the first reason is told.
        }
        throw kept;
    }
}

void fitCommand(const std::vector<std::string>& words, std::ostream& out)
{
    const CommandLine line(words, {"measure", "threshold", "leaveOut", "output"}, {"trustErrors"});
    const double threshold = line.positive("threshold", 0.9);
    if (threshold >= 1)
    {
        throw UsageError({"The threshold is not a fraction.", formatted("%g", threshold),
            "between 0 and 1", "command line, --threshold", "0.9 is 90 %."});
    }

    const std::string measure = line.text("measure", "fillingRatioPassed");
    const ResultsTable table = readResults(line.file(), measure);
    const FillingFit fit = fitOrReport(table, threshold, errorsOf(line), out);
    const FillingModel& model = fit.model;
    out << tableReport(table, fit) << '\n'
        << seriesReport(fit) << '\n'
        << planeReport(PlaneOf::criticalSize, model.criticalSize)
        << residualReport(PlaneOf::criticalSize, model.criticalSize, fit.criticalPoints) << '\n';
    if (model.fillingRatio)
    {
        out << planeReport(PlaneOf::fillingRatio, *model.fillingRatio)
            << formatted("    left out: %d rows below and %d above\n", fit.rowsBelow, fit.rowsAbove)
            << residualReport(PlaneOf::fillingRatio, *model.fillingRatio, fit.ratioPoints) << '\n';
    }
    else
    {
        out << "No plane for the filling ratio. " << fit.whyNoFillingRatio << "\n\n";
    }
    if (line.has("leaveOut"))
    {
        out << leaveOutReports(fit, line) << '\n';
    }
    out << publishedReport(model);
    if (line.has("output"))
    {
        writeModel(model, line.text("output", ""));
        out << "\nModel written to " << line.text("output", "") << '\n';
    }
}

// Lines of both planes may tell of the same quantity; each is said once a plane, as ranges differ.
std::vector<std::string> outsideModel(
    const FillingModel& model, const DieFilling& filling, bool sizeGiven)
{
    std::vector<std::string> outside =
        outsideRange(model.criticalSize.range, filling, SizeIs::answer);
    if (sizeGiven && model.fillingRatio)
    {
        for (const std::string& line :
            outsideRange(model.fillingRatio->range, filling, SizeIs::given))
        {
            if (std::find(outside.begin(), outside.end(), line) == outside.end())
            {
                outside.push_back(line);
            }
        }
    }
    return outside;
}

void allowOrRefuse(
    const std::vector<std::string>& outside, const CommandLine& line, std::ostream& out)
{
    if (!outside.empty() && !line.has("extrapolate"))
    {
        throw extrapolationRefused(outside, line.file());
    }
    for (const std::string& one : outside)
    {
        out << "WARNING: extrapolated. " << one << '\n';
    }
}

void predictCommand(const std::vector<std::string>& words, std::ostream& out)
{
    const CommandLine line(words, parameterNamesAnd({}), {"extrapolate"});
    const bool sizeGiven = line.has("particleDiameter");
    double DieFilling::*const unknown = sizeGiven ? nullptr : &DieFilling::particleDiameter;
    const DieFilling filling = fillingFrom(line, unknown);
    const FillingModel model = readModel(line.file());

    allowOrRefuse(outsideModel(model, filling, sizeGiven), line, out);
    out << "Prediction for\n"
        << conditionsReport(filling, unknown) << "gives\n"
        << predictionReport(model, filling, sizeGiven);
}

Sought soughtFrom(const CommandLine& line)
{
    const std::vector<std::string> names{"shoeSpeed", "particleDiameter", "dieDepth"};
    const std::string name = line.text("for", "");
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end())
    {
        throw UsageError(
            unknownName("quantity to invert for", name, names, "command line, --for").problem());
    }
    if (line.has(name))
    {
        throw UsageError({"The quantity that is sought is given as well.", "--" + name,
            "--for " + name + " without --" + name, "command line", "Leave one of them out."});
    }
    return static_cast<Sought>(place - names.begin());
}

void invertCommand(const std::vector<std::string>& words, std::ostream& out)
{
    const CommandLine line(words, parameterNamesAnd({"for"}), {"extrapolate"});
    const Sought sought = soughtFrom(line);
    const auto parameter = std::find_if(std::begin(parameters), std::end(parameters),
        [&](const Parameter& one) { return one.name == std::string(nameOf(sought)); });
    const DieFilling filling = fillingFrom(line, parameter->value);
    const FillingModel model = readModel(line.file());

    // The speed answers to a size that is given; the others answer the size itself.
    const Limit limit = limitOf(sought, model, filling);
    const SizeIs size = sought == Sought::shoeSpeed ? SizeIs::given : SizeIs::answer;
    allowOrRefuse(outsideRange(model.criticalSize.range, limit.filling, size), line, out);
    out << "For\n"
        << conditionsReport(filling, parameter->value) << limitReport(model, sought, limit);
}

void compareCommand(const std::vector<std::string>& words, std::ostream& out)
{
    out << publishedReport(readModel(CommandLine(words, {}, {}).file()));
}

void dispatch(const std::vector<std::string>& words, std::ostream& out)
{
    const std::string command = words.empty() ? "" : words.front();
    const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
    if (command == "fit")
    {
        fitCommand(rest, out);
    }
    else if (command == "predict")
    {
        predictCommand(rest, out);
    }
    else if (command == "invert")
    {
        invertCommand(rest, out);
    }
    else if (command == "compare")
    {
        compareCommand(rest, out);
    }
    else
    {
        throw UsageError(
            unknownName("command", command, {"fit", "predict", "invert", "compare"}, "command line")
                .problem());
    }
}

} // namespace

int fillingModelProgram(
    const std::vector<std::string>& words, std::ostream& out, std::ostream& errors)
{
    if (std::find(words.begin(), words.end(), "--help") != words.end())
    {
        out << usageText();
        return 0;
    }
    try
    {
        dispatch(words, out);
        return 0;
    }
    catch (const UsageError& error)
    {
        errors << error.what() << '\n' << (words.empty() ? "\n" + usageText() : "");
        return 2;
    }
    catch (const InputError& error)
    {
        errors << error.what() << '\n';
        return 1;
    }
}

} // namespace interstice
