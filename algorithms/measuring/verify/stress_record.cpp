#include "measuring/verify/stress_record.h"

#include <limits>

#include <nlohmann/json.hpp>

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

// Maximum number of listed violations of one kind, so that a single fault does not displace all others.
constexpr std::size_t kListedPerKind = 5;

Json methodJson(const StressMethodCoverage& method) {
    return {{"rays", method.rays},
            {"forms", method.forms},
            {"logs", method.logs},
            {"worst", method.worstBound},  // null where it is infinite
            {"where", method.worstWhere}};
}

StressMethodCoverage methodOf(const Json& json) {
    StressMethodCoverage method;
    json.at("rays").get_to(method.rays);
    json.at("forms").get_to(method.forms);
    json.at("logs").get_to(method.logs);
    const Json& worst = json.at("worst");
    method.worstBound = worst.is_null() ? std::numeric_limits<double>::infinity() : worst.get<double>();
    json.at("where").get_to(method.worstWhere);
    return method;
}

Json violationJson(const StressViolation& violation) {
    return {{"kind", violation.kind},      {"check", violation.fault.check}, {"detail", violation.fault.detail},
            {"method", violation.method},  {"rays", violation.rays},         {"map", violation.map},
            {"command", violation.command}};
}

StressViolation violationOf(const Json& json) {
    const auto text = [&](const char* name) { return json.at(name).get<std::string>(); };
    return {{text("check"), text("detail")}, text("method"), text("rays"), text("map"), text("command"), text("kind")};
}

}  // namespace

bool StressTally::lists(const std::string& kind) const {
    const auto found = countByKind_.find(kind);
    return found == countByKind_.end() || found->second < kListedPerKind;
}

void StressTally::add(const StressCase& one) {
    ++report_.cases;
    ++report_.maps[one.map];
    report_.sizes.insert(one.size);
    report_.violationCount += one.violationCount;
    for (const auto& [name, part] : one.methods) {
        StressMethodCoverage& whole = report_.methods[name];
        for (const auto& [family, rays] : part.rays) whole.rays[family] += rays;
        whole.forms.insert(part.forms.begin(), part.forms.end());
        whole.logs += part.logs;
        if (part.worstBound > whole.worstBound) {
            whole.worstBound = part.worstBound;
            whole.worstWhere = part.worstWhere;
        }
    }
    for (const auto& [name, part] : one.parts) {
        StressPartCoverage& whole = report_.parts[name];
        for (const auto& [kind, count] : part.tried) whole.tried[kind] += count;
        whole.refused += part.refused;
    }
    for (const StressViolation& violation : one.violations) {
        if (countByKind_[violation.kind]++ < kListedPerKind && !full()) report_.violations.push_back(violation);
    }
}

std::string stressCaseLine(const StressCase& one) {
    Json line{{"case", one.number}, {"map", one.map}, {"size", one.size}, {"violations", one.violationCount}};
    line["methods"] = Json::object();
    for (const auto& [name, method] : one.methods) line["methods"][name] = methodJson(method);
    line["parts"] = Json::object();
    for (const auto& [name, part] : one.parts) {
        line["parts"][name] = {{"tried", part.tried}, {"refused", part.refused}};
    }
    line["listed"] = Json::array();
    for (const StressViolation& violation : one.violations) line["listed"].push_back(violationJson(violation));
    return line.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::optional<StressCase> parseStressCase(std::string_view line) {
    try {
        const Json json = Json::parse(line);
        StressCase one;
        json.at("case").get_to(one.number);
        json.at("map").get_to(one.map);
        json.at("size").get_to(one.size);
        json.at("violations").get_to(one.violationCount);
        for (const auto& [name, method] : json.at("methods").items()) one.methods[name] = methodOf(method);
        for (const auto& [name, part] : json.at("parts").items()) {
            one.parts[name] = {part.at("tried").get<std::map<std::string, std::uint64_t>>(),
                               part.at("refused").get<std::uint64_t>()};
        }
        for (const Json& violation : json.at("listed")) one.violations.push_back(violationOf(violation));
        return one;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace relief
