#include <algorithm>

#include "measuring/text_table.h"
#include "measuring/verify/stress.h"
#include "measuring/verify/stress_cases.h"

namespace relief {

namespace {

std::string rayFamilies(const StressReport& report) {
    std::vector<TableRow> rows{{"family", "rays", "fewest per method"}};
    for (const StressRayFamily& family : stressRayFamilies()) {
        std::uint64_t sum = 0;
        std::uint64_t fewest = report.methods.empty() ? 0 : UINT64_MAX;
        for (const auto& [name, coverage] : report.methods) {
            const auto found = coverage.rays.find(std::string(family.name));
            const std::uint64_t rays = found == coverage.rays.end() ? 0 : found->second;
            sum += rays;
            fewest = std::min(fewest, rays);
        }
        rows.push_back({std::string(family.name), std::to_string(sum), std::to_string(fewest)});
    }
    return "rays, summed over all methods\n" + textTable(rows);
}

std::string methods(const StressReport& report) {
    std::vector<TableRow> rows{{"method", "rays", "logs", "forms", "steps/bound", "where"}};
    for (const auto& [name, coverage] : report.methods) {
        rows.push_back({name, std::to_string(coverage.total()), std::to_string(coverage.logs),
                        std::to_string(coverage.forms.size()), numberText(coverage.worstBound, 3),
                        coverage.worstWhere});
    }
    return "methods, with the largest ratio of steps to the step bound and where it occurred\n" + textTable(rows, 1, 5);
}

// Returns the total of each part that was run, and the count of each kind.
std::string parts(const StressReport& report) {
    std::string out;
    for (const auto& [name, part] : report.parts) {
        out += name + " (" + std::to_string(part.total());
        if (part.refused > 0) out += ", refused " + std::to_string(part.refused);
        out += ")\n ";
        for (const auto& [kind, count] : part.tried) out += " " + kind + " " + std::to_string(count);
        out += "\n";
    }
    return out;
}

std::string maps(const StressReport& report) {
    std::string out = "maps (number of cases)\n ";
    for (const auto& [name, cases] : report.maps) out += " " + name + " " + std::to_string(cases);
    out += "\nsizes\n ";
    for (const std::string& size : report.sizes) out += " " + size;
    return out + "\n";
}

}  // namespace

std::string stressText(const StressReport& report, std::uint64_t seed) {
    std::uint64_t rays = 0;
    for (const auto& [name, coverage] : report.methods) rays += coverage.total();
    std::string out =
        "seed " + std::to_string(seed) + ": " + std::to_string(report.cases) + " cases, " + std::to_string(rays) +
        " rays" + (report.seconds > 0 ? " in " + numberText(report.seconds, 3) + " s" : "") +
        (report.interrupted ? ", interrupted" : "") + "; violations: " + std::to_string(report.violationCount) +
        "\n\n" + rayFamilies(report) + "\n" + methods(report) + "\n" + parts(report) + maps(report);
    for (const StressViolation& v : report.violations) {
        out += "violation: " + v.fault.check + ", " + v.method + ", " + v.rays + " over " + v.map + ": " +
               v.fault.detail + ": " + v.command + "\n";
    }
    return out;
}

}  // namespace relief
