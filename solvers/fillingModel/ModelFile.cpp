// SPDX-License-Identifier: GPL-3.0-or-later
#include "ModelFile.hpp"

#include "Parameters.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace interstice
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr const char* format = "interstice filling model";
constexpr int formatVersion = 1;

Json planeToJson(const Plane& plane)
{
    const LinearFit& fit = plane.fit;
    Json json;
    json["names"] = fit.names;
    json["coefficients"] = std::vector<double>(
        fit.coefficients.data(), fit.coefficients.data() + fit.coefficients.size());
    json["covariance"] = Json::array();
    for (Eigen::Index i = 0; i < fit.covariance.rows(); ++i)
    {
        const Eigen::VectorXd row = fit.covariance.row(i).transpose();
        json["covariance"].push_back(std::vector<double>(row.data(), row.data() + row.size()));
    }
    json["points"] = fit.points;
    json["weighted"] = fit.weighted;
    json["rSquared"] = fit.rSquared;
    json["chiSquare"] = fit.chiSquare;
    json["scatter"] = fit.scatter;
    json["largestError"] = plane.largestError;
    for (std::size_t i = 0; i < rangedCount; ++i)
    {
        json["range"][rangedQuantities[i].name] = {plane.range[i].low, plane.range[i].high};
    }
    return json;
}

Json seriesToJson(const CriticalSizeRatio& size)
{
    Json json;
    json["criticalSizeRatio"] = size.value;
    json["error"] = size.error ? Json(*size.error) : Json();
    json["falls"] = size.falls;
    json["packings"] = size.packings;
    for (const Parameter& parameter : parameters)
    {
        json[parameter.name] = size.filling.*parameter.value;
    }
    return json;
}

InputError notAModel(const std::string& found, const std::string& file)
{
    return InputError({"The file is not a whole filling model.", found,
        "a file of fillingModel fit TABLE.csv --output FILE", file, "Write it again."});
}

// Where a number stands that no fit has given.
void require(bool holds, const char* what)
{
    if (!holds)
    {
        throw std::runtime_error(what);
    }
}

Plane planeFromJson(const Json& json, PlaneOf kind)
{
    Plane plane{};
    LinearFit& fit = plane.fit;
    fit.names = json.at("names").get<std::vector<std::string>>();
    require(fit.names == groupNames(kind), "names of a plane are not those of its groups");

    const auto coefficients = json.at("coefficients").get<std::vector<double>>();
    const auto rows = json.at("covariance").get<std::vector<std::vector<double>>>();
    const std::size_t size = fit.names.size() + 1;
    require(coefficients.size() == size, "coefficients are not as many as their names");
    require(rows.size() == size, "covariance has not a row for each coefficient");

    fit.coefficients =
        Eigen::Map<const Eigen::VectorXd>(coefficients.data(), static_cast<Eigen::Index>(size));
    fit.covariance.resize(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
    for (std::size_t i = 0; i < size; ++i)
    {
        require(rows[i].size() == size, "covariance is not square");
        fit.covariance.row(static_cast<Eigen::Index>(i)) =
            Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), static_cast<Eigen::Index>(size));
    }
    require(fit.covariance.diagonal().minCoeff() >= 0, "covariance has a negative variance");

    fit.points = json.at("points").get<int>();
    require(fit.degreesOfFreedom() > 0, "points are not more than the coefficients");
    fit.weighted = json.at("weighted").get<bool>();
    fit.rSquared = json.at("rSquared").get<double>();
    fit.chiSquare = json.at("chiSquare").get<double>();
    fit.scatter = json.at("scatter").get<double>();
    plane.largestError = json.at("largestError").get<double>();
    for (std::size_t i = 0; i < rangedCount; ++i)
    {
        const Json& limits = json.at("range").at(rangedQuantities[i].name);
        plane.range[i] = {limits.at(0).get<double>(), limits.at(1).get<double>()};
        require(plane.range[i].low <= plane.range[i].high, "a range ends before it begins");
    }
    return plane;
}

CriticalSizeRatio seriesFromJson(const Json& json)
{
    CriticalSizeRatio size{Crossing::within, json.at("criticalSizeRatio").get<double>(),
        std::nullopt, json.at("falls").get<int>(), {}, json.at("packings").get<int>()};
    if (!json.at("error").is_null())
    {
        size.error = json.at("error").get<double>();
    }
    size.filling.gravity = 9.81;
    for (const Parameter& parameter : parameters)
    {
        size.filling.*parameter.value = json.at(parameter.name).get<double>();
        require(size.filling.*parameter.value > 0, "a parameter of a series is not positive");
    }
    return size;
}

FillingModel modelFromJson(const Json& json)
{
    require(json.is_object() && json.value("format", "") == format, "another kind of file");
    require(json.at("formatVersion").get<int>() == formatVersion, "another version of the format");

    FillingModel model;
    model.table = json.at("table").get<std::string>();
    model.measure = json.at("measure").get<std::string>();
    model.threshold = json.at("threshold").get<double>();
    require(model.threshold > 0 && model.threshold < 1, "threshold is not between 0 and 1");
    model.criticalSize = planeFromJson(json.at("criticalSize"), PlaneOf::criticalSize);
    for (const Json& series : json.at("series"))
    {
        model.series.push_back(seriesFromJson(series));
    }
    if (!json.at("fillingRatio").is_null())
    {
        model.fillingRatio = planeFromJson(json.at("fillingRatio"), PlaneOf::fillingRatio);
    }
    return model;
}

} // namespace

void writeModel(const FillingModel& model, const std::string& file)
{
    Json json;
    json["format"] = format;
    json["formatVersion"] = formatVersion;
    json["program"] = INTERSTICE_VERSION;
    json["table"] = model.table;
    json["measure"] = model.measure;
    json["threshold"] = model.threshold;
    json["criticalSize"] = planeToJson(model.criticalSize);
    json["fillingRatio"] = model.fillingRatio ? planeToJson(*model.fillingRatio) : Json();
    json["series"] = Json::array();
    for (const CriticalSizeRatio& size : model.series)
    {
        json["series"].push_back(seriesToJson(size));
    }

    const std::string beside = file + ".new";
    std::ofstream out(beside);
    out << json.dump(2) << '\n';
    out.close();
    if (!out || std::rename(beside.c_str(), file.c_str()) != 0)
    {
        std::remove(beside.c_str());
        throw InputError({"The model cannot be written.", "no writable file", "a path to a file",
            file, "Check the folder, its permissions and the space left."});
    }
}

FillingModel readModel(const std::string& file)
{
    std::ifstream in(file);
    if (!in)
    {
        throw InputError({"The model cannot be opened.", "no readable file", "a model file", file,
            "Write it by fillingModel fit TABLE.csv --output FILE."});
    }
    try
    {
        return modelFromJson(Json::parse(in));
    }
    catch (const std::exception& error)
    {
        throw notAModel(error.what(), file);
    }
}

} // namespace interstice
