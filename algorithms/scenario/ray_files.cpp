#include "scenario/ray_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "relief/memory.h"
#include "scenario/step_cells.h"
#include "scenario/text_lines.h"

namespace relief {

namespace {

constexpr int kDigits = 17;
constexpr std::size_t kLinesAPiece = 8192;

ViewRay parseRay(std::string_view text, const std::string& fileName, std::size_t line) {
    std::array<double, 4> numbers{};
    if (std::count(text.begin(), text.end(), ',') != 3) {
        throw InputError(fileName, Message(MessageId::RayColumns, {{"line", line}, {"text", quoted(text)}}));
    }
    std::string_view rest = text;
    for (double& number : numbers) {
        const std::size_t comma = rest.find(',');
        number = finiteNumber(rest.substr(0, comma), fileName, line);
        rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void appendNumber(std::string& out, double value) {
    std::array<char, 32> buffer{};
    const auto result =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, kDigits);
    out.append(buffer.data(), result.ptr);
}

void appendNumber(std::string& out, std::int64_t value) {
    std::array<char, 24> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    out.append(buffer.data(), result.ptr);
}

}  // namespace

RayBlock parseRays(std::string_view text, const std::string& fileName) {
    text = withoutMark(text);
    const std::string_view header = takeLine(text);
    if (header != kRaysHeader) {
        throw InputError(
            fileName, Message(MessageId::RaysHeader, {{"header", std::string(kRaysHeader)}, {"text", quoted(header)}}));
    }
    const std::size_t most = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    requireMemory(byteProduct({most, RayBlock::kBytes}), fileName);
    RayBlock rays(most);
    std::size_t count = 0;
    forEachRow(text, [&](std::string_view row, std::size_t line) { rays.set(count++, parseRay(row, fileName, line)); });
    rays.resize(count);
    return rays;
}

ViewRay parseRayText(const std::string& text, const std::string& option) {
    try {
        return parseRay(text, option, 1);
    } catch (const InputError&) {
        throw InputError(option, Message(MessageId::NotARay, {{"text", quoted(text)}}));
    }
}

std::string_view outcomeName(Outcome outcome) {
    switch (outcome) {
        case Outcome::Hit:
            return "hit";
        case Outcome::Limit:
            return "limit";
        case Outcome::Miss:
        case Outcome::Unset:
            break;
    }
    return "miss";
}

void appendHitLines(std::string& out, const HitBlock& hits, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        out += outcomeName(hits.outcome[i]);
        const bool hit = hits.outcome[i] == Outcome::Hit;
        for (const double value : {hits.lambda[i], hits.s[i], hits.t[i]}) {
            out += ',';
            if (hit) appendNumber(out, value);
        }
        out += ',';
        appendNumber(out, static_cast<std::int64_t>(hits.steps[i]));
        out += '\n';
    }
}

namespace {

// Formats lines [first, last) by `append` in parallel; the text is the same for any number of threads.
template <class Append>
std::string joinedLines(std::size_t count, Work& work, const Append& append) {
    std::vector<std::string> pieces((count + kLinesAPiece - 1) / kLinesAPiece);
    parallelFor(work, pieces.size(), [&](std::size_t p) {
        const std::size_t first = p * kLinesAPiece;
        append(pieces[p], first, std::min(first + kLinesAPiece, count));
    });
    std::size_t bytes = 0;
    for (const std::string& piece : pieces) bytes += piece.size();
    std::string out;
    out.reserve(bytes);
    for (const std::string& piece : pieces) out += piece;
    return out;
}

}  // namespace

std::string hitLines(const HitBlock& hits, Work& work) {
    return joinedLines(hits.size(), work, [&](std::string& out, std::size_t first, std::size_t last) {
        appendHitLines(out, hits, first, last);
    });
}

std::string rayLines(const RayBlock& rays, Work& work) {
    return joinedLines(rays.size(), work, [&](std::string& out, std::size_t first, std::size_t last) {
        for (std::size_t r = first; r < last; ++r) {
            const ViewRay ray = rays[r];
            appendNumber(out, ray.s0);
            for (const double value : {ray.t0, ray.a, ray.b}) {
                out += ',';
                appendNumber(out, value);
            }
            out += '\n';
        }
    });
}

void appendStepLines(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray) {
    for (std::size_t s = log.begin[inLog]; s < log.begin[inLog + 1]; ++s) {
        const std::size_t before = out.size();
        const auto comma = [&] {
            if (out.size() > before) out += ',';
        };
        forEachColumn(
            log.steps[s], ray, s - log.begin[inLog] + 1,
            [&](std::string_view, auto value) {
                comma();
                appendNumber(out, value);
            },
            [&](std::string_view, std::string_view name) {
                comma();
                out += name;
            });
        out.append(",").append(subjectName(log.steps[s].subject));
        for (const std::optional<double>& value : subjectValues(log.steps[s])) {
            out += ',';
            if (value) appendNumber(out, *value);
        }
        out += '\n';
    }
}

void appendStepObjects(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray, bool& empty) {
    for (std::size_t s = log.begin[inLog]; s < log.begin[inLog + 1]; ++s) {
        out += empty ? "\n  {" : ",\n  {";
        empty = false;
        const std::size_t before = out.size();
        const auto key = [&](std::string_view name) {
            out.append(out.size() > before ? ", \"" : "\"").append(name).append("\": ");
        };
        forEachColumn(
            log.steps[s], ray, s - log.begin[inLog] + 1,
            [&](std::string_view name, auto value) {
                key(name);
                // JSON has no NaN and no infinity.
                if (!std::isfinite(static_cast<double>(value))) {
                    out += "null";
                } else {
                    appendNumber(out, value);
                }
            },
            [&](std::string_view name, std::string_view text) {
                key(name);
                out.append("\"").append(text).append("\"");
            });
        key("kind");
        out.append("\"").append(subjectName(log.steps[s].subject)).append("\"");
        const SubjectValues values = subjectValues(log.steps[s]);
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (!values[n] || !std::isfinite(*values[n])) continue;
            key(kSubjectColumns[n + 1]);
            appendNumber(out, *values[n]);
        }
        out += '}';
    }
}

}  // namespace relief
