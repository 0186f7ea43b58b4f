#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "relief/cell_grid.h"
#include "scenario/breakpoint.h"
#include "scenario/json_reader.h"
#include "scenario/ray_files.h"
#include "scenario/step_columns.h"
#include "scenario/text_lines.h"

namespace relief {

namespace {

// Limits on texel indices: the largest for which doubles represent all integers, and the limit for indices outside the
// picture.
constexpr std::int64_t kFarthestTexel = std::int64_t{1} << 53;
constexpr std::int64_t kFarthestBeside = std::int64_t{1} << 30;
// Tolerance for heights, which must be 1 - lambda but may have been written with few digits.
constexpr double kSameHeight = 1e-5;

// The position of a step in the file, for error messages.
struct Place {
    const std::string& fileName;
    std::size_t line;

    [[noreturn]] void refuse(Message message) const { throw InputError(fileName, std::move(message)); }

    std::int64_t whole(std::string_view text, std::int64_t low, std::int64_t high) const {
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
        if (!good) {
            refuse(
                Message(MessageId::StepWhole, {{"line", line}, {"text", quoted(text)}, {"low", low}, {"high", high}}));
        }
        return value;
    }
    double unit(const char* what, double value) const {
        if (!(value >= 0 && value <= 1)) {
            refuse(Message(MessageId::StepOutsideSlab, {{"line", line}, {"what", what}, {"value", value}}));
        }
        return value;
    }
    void height(const char* what, double value, double lambda) const {
        if (!(std::abs(value - (1 - lambda)) <= kSameHeight)) {
            refuse(Message(MessageId::StepHeights,
                           {{"line", line}, {"what", what}, {"value", value}, {"wanted", 1 - lambda}}));
        }
    }
    template <class Enum, std::size_t N>
    Enum word(const char* what, std::string_view text, const std::array<std::string_view, N>& names) const {
        std::string known;
        for (std::size_t n = 0; n < N; ++n) {
            if (names[n] == text) return static_cast<Enum>(n);
            known += (known.empty() ? "" : ", ") + std::string(names[n]);
        }
        refuse(
            Message(MessageId::StepWord, {{"line", line}, {"what", what}, {"text", quoted(text)}, {"known", known}}));
    }
};

// The columns of a line about the kind of what was examined, in the order of kSubjectColumns.
struct SubjectRow {
    std::string kind;
    std::array<std::optional<double>, kSubjectColumns.size() - 1> values;
};

// Texel::level of a step whose file does not state the kind of what was examined.
constexpr int kUnknownLevel = -1;

Subject subjectOf(const Step& step, const SubjectRow& row, const Place& place) {
    if (row.kind.empty()) return subject::Texel{kUnknownLevel, step.i, step.j, step.value};
    const auto lacks = [&](std::size_t at, MessageId expected) {
        const std::string key(kSubjectColumns[at + 1]);
        place.refuse(Message(MessageId::StepField, {{"line", place.line}, {"key", key}, {"wanted", expected}}));
    };
    const auto real = [&](std::size_t at) {
        const auto& value = row.values[at];
        if (!value || !std::isfinite(*value)) lacks(at, MessageId::WantNumber);
        return value.value_or(0);
    };
    constexpr std::size_t kS = 0, kT = 1, kZ = 2, kWidth = 3, kHeight = 4, kIndex = 5, kCount = 6;
    const auto whole = [&](std::size_t at, int low) {
        constexpr int kMost = 1 << 24;
        const double value = real(at);
        if (!(value >= low && value <= kMost && value == std::floor(value))) lacks(at, MessageId::WantWhole);
        return static_cast<int>(value);
    };
    enum class Kind : std::uint8_t {
        Texel,
        Quad,
        Voxel,
        Sphere,
        Cone,
        Layer,
        Point,
        SquareCone,
        RefinedVoxel,
        RefinedSphere,
        RelaxedCone
    };
    const Kind kind = place.word<Kind>("kind", row.kind, kSubjectNames);
    switch (kind) {
        case Kind::Texel: {
            std::optional<subject::LevelPoint> ray;
            if (row.values[kS] && row.values[kT]) ray = {*row.values[kS], *row.values[kT]};
            return subject::Texel{step.level, step.i, step.j, step.value, ray};
        }
        case Kind::Quad:
            return subject::Quad{real(kS), real(kT), real(kWidth), real(kHeight), step.value};
        case Kind::Voxel:
        case Kind::RefinedVoxel:
            return subject::Voxel{
                step.i, step.j, step.k, whole(kWidth, 1), whole(kCount, 1), step.value, kind == Kind::RefinedVoxel};
        case Kind::Sphere:
        case Kind::RefinedSphere:
            return subject::Sphere{real(kS), real(kT), real(kZ), step.value, kind == Kind::RefinedSphere};
        case Kind::Cone:
        case Kind::SquareCone:
        case Kind::RelaxedCone: {
            const double slope = step.decision == Decision::Advance ? step.value : 0;
            const bool ofCell = row.values[kWidth].value_or(0) > 0;
            return subject::Cone{real(kS),
                                 real(kT),
                                 real(kZ),
                                 slope,
                                 whole(kIndex, 0),
                                 whole(kCount, 1),
                                 ofCell,
                                 kind == Kind::SquareCone,
                                 kind == Kind::RelaxedCone};
        }
        case Kind::Layer:
            return subject::Layer{whole(kIndex, 0), whole(kCount, 1), step.value};
        case Kind::Point:
            break;
    }
    return subject::Point{step.value};
}

// One line of the file: a step, with the numbers of ray and step.
struct Row {
    std::int64_t ray = 0;
    std::int64_t number = 0;
    Step step;
    std::optional<double> zIn, zOut;
};

void check(const Row& row, const Place& place) {
    const Step& step = row.step;
    place.unit("lambda_in", step.lambdaIn);
    place.unit("lambda_out", step.lambdaOut);
    place.unit("lambda_after", step.lambdaAfter);
    if (step.lambdaOut < step.lambdaIn) {
        place.refuse(Message(MessageId::StepBackwards,
                             {{"line", place.line}, {"value", step.lambdaOut}, {"wanted", step.lambdaIn}}));
    }
    if (row.zIn) place.height("z_in", *row.zIn, step.lambdaIn);
    if (row.zOut) place.height("z_out", *row.zOut, step.lambdaOut);
}

// The columns of the header after those that every file has.
struct FurtherNames {
    struct Column {
        std::optional<std::size_t> subject;  // index in kSubjectColumns
        std::size_t further = 0;             // otherwise: index in `names`
    };
    std::vector<Column> columns;
    std::vector<std::string> names;  // of columns that are none of ours
};

FurtherNames furtherNames(std::string_view header, const std::string& fileName) {
    const auto names = columnsAfter(header, kStepColumns);
    if (!names) {
        throw InputError(fileName, Message(MessageId::RaysHeader,
                                           {{"header", std::string(kStepsHeader)}, {"text", quoted(header)}}));
    }
    FurtherNames further;
    for (const std::string_view name : *names) {
        const auto found = std::find(kSubjectColumns.begin(), kSubjectColumns.end(), name);
        FurtherNames::Column& column = further.columns.emplace_back();
        if (found != kSubjectColumns.end()) {
            column.subject = static_cast<std::size_t>(found - kSubjectColumns.begin());
        } else {
            column.further = further.names.size();
            further.names.emplace_back(name);
        }
    }
    return further;
}

// keep(column, cell) is called for the cells of further columns.
template <class Keep>
Row csvRow(std::string_view text, const FurtherNames& further, const Place& place, const Keep& keep) {
    constexpr std::size_t kColumns = 14;
    requireCells(text, kColumns + further.columns.size(), place.fileName, place.line);
    Row row;
    Step& step = row.step;
    const auto number = [&] { return finiteNumber(takeCell(text), place.fileName, place.line); };
    const auto texel = [&] { return place.whole(takeCell(text), -kFarthestTexel, kFarthestTexel); };
    constexpr std::int64_t kMost = std::int64_t{1} << 40;
    row.ray = place.whole(takeCell(text), 0, kMost);
    row.number = place.whole(takeCell(text), 1, kMost);
    step.phase = place.word<Phase>("phase", takeCell(text), kPhaseNames);
    step.level = static_cast<int>(place.whole(takeCell(text), 0, kMostLevels));
    step.i = texel();
    step.j = texel();
    step.k = texel();
    step.lambdaIn = number();
    step.lambdaOut = number();
    row.zIn = number();
    row.zOut = number();
    const std::string_view value = takeCell(text);
    // A cone that contains all of space has no finite slope; all spellings of such a value are accepted.
    const bool endless = value == "inf" || value == "-inf" || value == "nan" || value == "-nan";
    step.value = endless ? HUGE_VAL : finiteNumber(value, place.fileName, place.line);
    step.decision = place.word<Decision>("decision", takeCell(text), kDecisionNames);
    step.lambdaAfter = number();
    SubjectRow subject;
    for (const FurtherNames::Column& column : further.columns) {
        const std::string_view cell = takeCell(text);
        if (!column.subject) keep(column.further, cell);
        if (!column.subject || cell.empty()) continue;
        if (*column.subject == 0) {
            subject.kind = cell;
        } else {
            subject.values[*column.subject - 1] = finiteNumber(cell, place.fileName, place.line);
        }
    }
    step.subject = subjectOf(step, subject, place);
    check(row, place);
    return row;
}

Row jsonRow(const Json& object, const Place& place) {
    const auto wrong = [&](const char* key, MessageId expected) {
        place.refuse(Message(MessageId::StepField, {{"line", place.line}, {"key", key}, {"wanted", expected}}));
    };
    const auto whole = [&](const char* key, std::optional<std::int64_t> otherwise) -> std::int64_t {
        const auto found = object.find(key);
        if (found == object.end() && otherwise) return *otherwise;
        if (found == object.end() || !found->is_number_integer()) wrong(key, MessageId::WantWhole);
        if (found->is_number_unsigned() && found->get<std::uint64_t>() > kFarthestTexel)
            wrong(key, MessageId::WantWhole);
        const auto value = found->get<std::int64_t>();
        if (value < -kFarthestTexel || value > kFarthestTexel) wrong(key, MessageId::WantWhole);
        return value;
    };
    const auto real = [&](const char* key) -> double {
        const auto found = object.find(key);
        if (found == object.end() || !found->is_number()) wrong(key, MessageId::WantNumber);
        return found->get<double>();
    };
    const auto text = [&](const char* key) -> std::string {
        const auto found = object.find(key);
        if (found == object.end() || !found->is_string()) wrong(key, MessageId::WantText);
        return found->get<std::string>();
    };
    Row row;
    Step& step = row.step;
    row.ray = whole("ray", std::nullopt);
    row.number = whole("number", std::nullopt);
    if (object.contains("phase")) step.phase = place.word<Phase>("phase", text("phase"), kPhaseNames);
    const std::int64_t level = whole("level", 0);
    if (level < 0 || level > kMostLevels) wrong("level", MessageId::WordLevel);
    step.level = static_cast<int>(level);
    step.i = whole("i", 0);
    step.j = whole("j", 0);
    step.k = whole("k", 0);
    step.lambdaIn = real("lambda_in");
    step.lambdaOut = real("lambda_out");
    if (object.contains("z_in")) row.zIn = real("z_in");
    if (object.contains("z_out")) row.zOut = real("z_out");
    step.value = object.contains("value") && object["value"].is_null() ? HUGE_VAL : real("value");
    step.decision = place.word<Decision>("decision", text("decision"), kDecisionNames);
    step.lambdaAfter = real("lambda_after");
    SubjectRow subject;
    if (object.contains("kind")) subject.kind = text("kind");
    for (std::size_t n = 0; n < subject.values.size(); ++n) {
        const std::string key(kSubjectColumns[n + 1]);
        if (object.contains(key)) subject.values[n] = real(key.c_str());
    }
    step.subject = subjectOf(step, subject, place);
    check(row, place);
    return row;
}

// Collects rows into the logs of rays.
class Gatherer {
  public:
    explicit Gatherer(std::size_t rays) : logs_(rays), rows_(rays) {}

    // Returns the index of the further column of this name, which is made if there is none.
    std::size_t column(const std::string& name) {
        const auto found =
            std::find_if(further_.begin(), further_.end(), [&](const FurtherColumn& c) { return c.name == name; });
        if (found != further_.end()) return static_cast<std::size_t>(found - further_.begin());
        further_.push_back({name, {}});
        return further_.size() - 1;
    }
    // Keeps a cell of the row that is added next.
    void keep(std::size_t column, std::string_view cell) {
        std::vector<std::string>& cells = further_[column].cells;
        cells.resize(count_ + 1);
        cells[count_] = cell;
    }

    void add(const Row& row, const Place& place) {
        const auto ray = static_cast<std::size_t>(row.ray);
        if (row.ray < 0 || ray >= logs_.size()) {
            place.refuse(
                Message(MessageId::StepNoRay, {{"line", place.line}, {"ray", row.ray}, {"count", logs_.size()}}));
        }
        const bool together = logs_[ray].empty() || ray == last_;
        if (!together || row.number != static_cast<std::int64_t>(logs_[ray].size()) + 1) {
            place.refuse(
                Message(MessageId::StepOrder, {{"line", place.line}, {"number", row.number}, {"ray", row.ray}}));
        }
        logs_[ray].push_back(row.step);
        rows_[ray].push_back(count_++);
        last_ = ray;
    }
    // Returns the further columns, with a cell for each step of take().
    std::vector<FurtherColumn> further() const {
        std::vector<FurtherColumn> out;
        for (const FurtherColumn& column : further_) {
            std::vector<std::string>& cells = out.emplace_back(FurtherColumn{column.name, {}}).cells;
            for (const std::vector<std::size_t>& rows : rows_) {
                for (const std::size_t row : rows) {
                    cells.push_back(row < column.cells.size() ? column.cells[row] : std::string());
                }
            }
        }
        return out;
    }
    StepLog take() const {
        StepLog log;
        for (const std::vector<Step>& steps : logs_) {
            log.steps.insert(log.steps.end(), steps.begin(), steps.end());
            log.begin.push_back(log.steps.size());
            log.reads.push_back(0);
        }
        return log;
    }

  private:
    std::vector<std::vector<Step>> logs_;
    std::vector<std::vector<std::size_t>> rows_;  // of the file, for each step of logs_
    std::vector<FurtherColumn> further_;          // in the order of the file
    std::size_t count_ = 0;
    std::size_t last_ = 0;
};

// Returns the line on which each object of the array begins, in a single pass over the text.
std::vector<std::size_t> objectLines(std::string_view text) {
    std::vector<std::size_t> lines;
    std::size_t line = 1;
    bool inText = false;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (inText && c == '\\') ++at;
        if (c == '"') inText = !inText;
        if (inText) continue;
        if (depth == 1 && c == '{') lines.push_back(line);
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
    }
    return lines;
}

bool isOurColumn(std::string_view name) {
    std::string_view ours = kStepColumns;
    while (!ours.empty()) {
        if (takeCell(ours) == name) return true;
    }
    return std::find(kSubjectColumns.begin(), kSubjectColumns.end(), name) != kSubjectColumns.end();
}

void gatherJson(const std::string& text, const std::string& fileName, Gatherer& gatherer) {
    const Json json = parseJson(text, fileName);
    const std::vector<std::size_t> lines = objectLines(text);
    for (std::size_t n = 0; n < json.size(); ++n) {
        const Place place{fileName, n < lines.size() ? lines[n] : 1};
        if (!json[n].is_object()) {
            place.refuse(Message(MessageId::ScenarioWrongType,
                                 {{"line", place.line}, {"key", "steps"}, {"wanted", MessageId::WantObjects}}));
        }
        for (const auto& [key, value] : json[n].items()) {
            if (isOurColumn(key) || value.is_null()) continue;
            gatherer.keep(gatherer.column(key), value.is_string() ? value.get<std::string>() : value.dump());
        }
        gatherer.add(jsonRow(json[n], place), place);
    }
}

}  // namespace

StepLog parseSteps(std::string_view text, const std::string& fileName, std::size_t rays,
                   std::vector<FurtherColumn>* further) {
    Gatherer gatherer(rays);
    text = withoutMark(text);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin != std::string_view::npos && text[begin] == '[') {
        gatherJson(std::string(text), fileName, gatherer);
    } else {
        const FurtherNames names = furtherNames(takeLine(text), fileName);
        std::vector<std::size_t> columns;
        for (const std::string& name : names.names) columns.push_back(gatherer.column(name));
        forEachRow(text, [&](std::string_view row, std::size_t line) {
            const Place place{fileName, line};
            gatherer.add(
                csvRow(row, names, place,
                       [&](std::size_t column, std::string_view cell) { gatherer.keep(columns[column], cell); }),
                place);
        });
    }
    if (further != nullptr) *further = gatherer.further();
    return gatherer.take();
}

namespace {

// One axis of a field, with the ray's path along it: checks indices and determines periods.
struct PlaceAxis {
    const GridAxis& axis;
    const RayAxis& along;

    // Returns false if there is no such texel, cell or voxel; sets the period in which the ray meets it. known: the
    // file states what was examined.
    bool place(std::int64_t name, const Step& step, bool known, std::int64_t& period) const {
        const bool cells = !step.namesTexelUnderRay();
        const auto* const voxel = step.tests() ? nullptr : step.as<subject::Voxel>();
        const std::int64_t side = voxel != nullptr ? voxel->footprint : std::int64_t{1} << std::min(step.level, 31);
        const bool cell = cells && voxel == nullptr && step.level == 0;
        const std::int64_t index = cell ? name - axis.firstName : name;
        const std::int64_t most = cells ? axis.cells : axis.texels;
        std::int64_t count = (most - 1) / side + 1;
        // Steps without a kind are numbered either as voxels of maps, from 0, or as cells, from their first index; both
        // are accepted.
        if (cell && !known) count = axis.cells - axis.firstName;
        period = 0;
        if (index < 0 || index >= count) {
            // A ray may begin and end outside the picture.
            const bool end = step.decision == Decision::Start || step.decision == Decision::Miss;
            return end && step.level == 0 && std::abs(name) < kFarthestBeside;
        }
        if (!axis.wraps) return true;
        const auto first = static_cast<double>(index * side);
        const double last = std::min(static_cast<double>((index + 1) * side), static_cast<double>(most));
        const double middle = 0.5 * (first + last) - (cells ? axis.shift : 0.0);
        // A map's value is read where the step begins, a height where it ends.
        const double ofPoint = step.trustsMap() ? step.lambdaIn : step.lambdaOut;
        const double lambda = cells ? 0.5 * (step.lambdaIn + step.lambdaOut) : ofPoint;
        const double at = along.start - axis.shift + lambda * along.run;
        const double periods = std::round((at - middle) / axis.texels);
        period = std::abs(periods) < static_cast<double>(kFarthestTexel) ? static_cast<std::int64_t>(periods) : 0;
        return true;
    }
};

// Sets periods and missing kinds. Returns the index of the first step that names no texel of the field, or the number
// of steps if there is none. known: whether the file states what the step examined; cells: the other steps examined
// cells, otherwise points of the ray.
std::size_t placeAll(std::span<Step> steps, const std::vector<bool>& known, const CellGrid& grid, const GridRay& ray,
                     bool cells) {
    const PlaceAxis x{grid.x, ray.x};
    const PlaceAxis y{grid.y, ray.y};
    for (std::size_t n = 0; n < steps.size(); ++n) {
        Step& step = steps[n];
        if (!known[n]) {
            if (cells) {
                step.subject = subject::Texel{step.level, step.i, step.j, step.value};
            } else {
                step.subject = subject::Point{step.value};
            }
        }
        if (!x.place(step.i, step, known[n], step.periodX) || !y.place(step.j, step, known[n], step.periodY)) return n;
        auto* const voxel = std::get_if<subject::Voxel>(&step.subject);
        if (voxel == nullptr || !step.tests()) continue;
        // The columns contain the index of the tested cell; the voxel's index follows from it.
        voxel->i = (step.i - grid.x.firstName) / voxel->footprint;
        voxel->j = (step.j - grid.y.firstName) / voxel->footprint;
    }
    return steps.size();
}

}  // namespace

void placeSteps(std::span<Step> steps, const ViewRay& ray, const HeightField& field, const std::string& fileName,
                std::size_t number) {
    const CellGrid grid(field);
    const GridRay inCells(grid, ray);
    const bool cells = std::any_of(steps.begin(), steps.end(), [](const Step& step) {
        return step.level > 0 || step.decision == Decision::Skip || step.decision == Decision::Descend ||
               step.decision == Decision::Ascend || step.decision == Decision::Test;
    });
    std::vector<bool> known;
    for (const Step& step : steps) {
        const auto* const texel = step.as<subject::Texel>();
        known.push_back(texel == nullptr || texel->level != kUnknownLevel);
    }
    std::size_t wrong = placeAll(steps, known, grid, inCells, cells);
    // Indices beyond the picture's edge may be those of cells.
    if (wrong < steps.size() && !cells) wrong = placeAll(steps, known, grid, inCells, true);
    if (wrong >= steps.size()) return;
    const Step& step = steps[wrong];
    throw InputError(fileName, Message(MessageId::StepNoTexel, {{"ray", number},
                                                                {"number", wrong + 1},
                                                                {"level", step.level},
                                                                {"width", field.width()},
                                                                {"height", field.height()},
                                                                {"i", step.i},
                                                                {"j", step.j}}));
}

std::span<Step> stepsOf(StepLog& log, std::size_t ray) {
    return std::span(log.steps).subspan(log.begin[ray], log.begin[ray + 1] - log.begin[ray]);
}

std::span<const Step> stepsOf(const StepLog& log, std::size_t ray) {
    return std::span(log.steps).subspan(log.begin[ray], log.begin[ray + 1] - log.begin[ray]);
}

Hit answerOf(std::span<const Step> steps, const ViewRay& ray) {
    if (steps.empty()) return Hit::none(Outcome::Limit);
    const Step& last = steps.back();
    if (last.decision == Decision::Hit) return Hit::at(ray, last.lambdaAfter);
    return Hit::none(last.decision == Decision::Miss ? Outcome::Miss : Outcome::Limit);
}

}  // namespace relief
