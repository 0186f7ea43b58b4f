#include "panes/pyramid/pyramid_drawing.h"

#include <cmath>
#include <map>

#include "painting/chart.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using relief::Decision;
using relief::Message;
using relief::MessageId;

// Only this many steps around the chosen one are marked: more could not be distinguished, and redrawing stays fast.
constexpr std::size_t kMarkedSteps = 4000;
constexpr std::size_t kNumberedTexels = 80;
constexpr double kTitleSize = 0.9;

// Title of a level, shortened to fit the room.
Message levelTitle(const relief::Pyramid& pyramid, int level, double room) {
    constexpr MessageId kWhole[] = {MessageId::DrawLevelMean, MessageId::DrawLevelMax, MessageId::DrawLevelMin};
    static_assert(static_cast<int>(relief::PyramidKind::Max) == 1 && static_cast<int>(relief::PyramidKind::Min) == 2);
    const relief::FloatImage& image = pyramid.level(level);
    for (const MessageId id : {kWhole[static_cast<std::size_t>(pyramid.kind())], MessageId::DrawLevelShort}) {
        const Message title(id, {{"level", level}, {"width", image.width()}, {"height", image.height()}});
        if (chart::widthOf(title) * kTitleSize / chart::kTextSize <= room) return title;
    }
    return plainText(std::to_string(level));
}

struct Window {
    Box domain;
    bool whole = true;
};

// The part of the texture shown in all blocks: everything, or the surroundings of the ray in whole texels, widened in
// one direction to have at least this aspect.
Window windowOf(const PyramidSource& source, double aspect) {
    const Box whole = source.overCells ? cellDomain(*source.field) : texelDomain(*source.field);
    if (!source.nearRay || !source.hasRay) return {whole, true};
    constexpr double kAround = 0.3;  // as a share of the ray's extent
    constexpr double kLeast = 12;    // in texels
    const RayPath path(*source.field, source.ray);
    const Point from = path.at(0);
    const Point to = path.at(rayEnd(source.hit, source.steps));
    double width = std::max(std::abs(to.x - from.x) * (1 + 2 * kAround), kLeast);
    double height = std::max(std::abs(to.y - from.y) * (1 + 2 * kAround), kLeast);
    constexpr double kSlenderest = 3;
    const double shape = source.slender ? std::clamp(width / height, 1 / kSlenderest, kSlenderest) : aspect;
    width = std::max(width, height * shape);
    height = std::max(height, width / shape);
    if (!(width < whole.width() && height < whole.height())) return {whole, true};
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    // Aligned with the borders of cells; for means, of texels.
    const auto snap = [](double v, double origin) { return std::round(v - origin) + origin; };
    const double x0 = snap(middle.x - width / 2, whole.x0);
    const double y0 = snap(middle.y - height / 2, whole.y0);
    return {{x0, y0, x0 + std::ceil(width), y0 + std::ceil(height)}, false};
}

// The aspect of the surroundings that shows the ray largest in this room; among equals, the one that fills it best.
struct Arrangement {
    Window window;
    std::vector<LevelBlock> blocks;
};
Arrangement arrange(const PyramidSource& source, double width, double height) {
    Arrangement best;
    double bestScore = -1;
    for (const double aspect : {1.0, 0.6, 0.8, 1.3, 1.6, 2.2}) {
        Arrangement next;
        next.window = windowOf(source, aspect);
        next.blocks = pyramidLayout(source.pyramid->levels(), next.window.domain, width, height);
        const Box& small = next.blocks.back().box;
        const double scale = next.blocks.front().unitX() * next.blocks.back().unitX();
        const double score = scale * std::pow(small.width() * small.height(), 0.3);
        if (score > bestScore) {
            best = std::move(next);
            bestScore = score;
        }
        if (best.window.whole || source.slender) break;  // the aspect has no effect
    }
    return best;
}

// A texel of one level that steps concern, with the indices of these steps.
struct Visit {
    Box box;
    std::vector<std::size_t> steps;
};
using Texel = std::tuple<bool, int, std::int64_t, std::int64_t>;  // a voxel, or a texel of the level

class Marks {
  public:
    Marks(const PyramidSource& source, const PyramidPicture& picture, int step)
        : source_(source),
          blocks_(picture.blocks),
          path_(*source.field, source.ray),
          wraps_(picture.wraps),
          chosen_(static_cast<std::size_t>(std::max(step, 0))) {}

    Drawing take() {
        if (source_.steps != nullptr && !source_.steps->empty()) {
            chosen_ = std::min(chosen_, source_.steps->size() - 1);
            if (source_.overCells) texels();
            chosenTexel();
        }
        for (const LevelBlock& block : blocks_) ray(block);
        return std::move(drawing_);
    }

  private:
    const relief::Step& step(std::size_t k) const { return (*source_.steps)[k]; }
    Emphasis emphasis(std::size_t k) const { return k > chosen_ ? Emphasis::Faint : Emphasis::Normal; }

    std::vector<Box> boxesOf(const relief::Step& s) const {
        if (s.level < 0 || s.level >= static_cast<int>(blocks_.size())) return {};
        const LevelBlock& block = blocks_[static_cast<std::size_t>(s.level)];
        std::vector<Box> boxes = wrapped(stepBox(*source_.field, s, source_.baseLevel), block.domain, wraps_);
        for (Box& box : boxes) box = block.toDrawing(box);
        return boxes;
    }

    void texels() {
        const std::size_t first = chosen_ > kMarkedSteps ? chosen_ - kMarkedSteps : 0;
        const std::size_t last = std::min(source_.steps->size(), chosen_ + kMarkedSteps);
        std::map<Texel, Visit> visits;
        for (std::size_t k = first; k < last; ++k) {
            const relief::Step& s = step(k);
            Visit& visit = visits[{liesInVoxel(s), s.level, s.i, s.j}];
            visit.steps.push_back(k);
            for (const Box& box : boxesOf(s)) {
                visit.box = box;
                // Outlines of several decisions about one texel are nested.
                const auto ring = static_cast<double>(std::min<std::size_t>(visit.steps.size() - 1, 3));
                drawing_.add(stepId(k), roleOf(s.decision), Rectangle{box, false, 0.5 + 2.2 * ring, 4}, emphasis(k));
            }
        }
        numbers(visits);
    }

    void numbers(const std::map<Texel, Visit>& visits) {
        for (const auto& [texel, visit] : visits) {
            const bool near =
                visit.steps.back() + kNumberedTexels > chosen_ && visit.steps.front() < chosen_ + kNumberedTexels;
            if (visit.box.empty() || !near) continue;
            constexpr std::size_t kMostNumbers = 3;
            std::string text;
            std::size_t last = visit.steps.front();
            bool chosen = false;
            for (std::size_t n = 0; n < visit.steps.size(); ++n) {
                if (n < kMostNumbers) {
                    if (n > 0) text += ' ';
                    text += std::to_string(visit.steps[n] + 1);
                }
                if (visit.steps[n] <= chosen_) last = visit.steps[n];
                chosen = chosen || visit.steps[n] == chosen_;
            }
            if (visit.steps.size() > kMostNumbers) text += " …";
            const Emphasis strength = chosen ? Emphasis::Strong : emphasis(visit.steps.front());
            drawing_.add({}, roleOf(step(last).decision),
                         Label{.at = {visit.box.x0, visit.box.y0},
                               .text = plainText(text),
                               .anchor = Anchor::TopLeft,
                               .size = 0.8,
                               .offset = {1.5, 1.5},
                               .plate = true,
                               .yields = true,
                               .room = visit.box,
                               .evades = true},
                         strength);
        }
    }

    void chosenTexel() {
        const relief::Step& s = step(chosen_);
        for (const Box& box : boxesOf(s)) {
            drawing_.add({}, roleOf(s.decision), Rectangle{box, true, 0, 6});
            drawing_.add(stepId(chosen_), Role::Highlight, Rectangle{box, false, -1, 8});
        }
    }

    void line(const LevelBlock& block, double from, double to, Role role, Emphasis strength) {
        for (const Segment& piece : wrapped(Segment{path_.at(from), path_.at(to)}, block.domain, wraps_)) {
            drawing_.add({ItemKind::Ray, block.level, 0, 0}, role,
                         Polyline{{block.toDrawing(piece.first), block.toDrawing(piece.second)}, false}, strength);
        }
    }

    void point(const LevelBlock& block, double lambda, Role role, const Primitive& primitive) {
        for (const Segment& piece : wrapped(Segment{path_.at(lambda), path_.at(lambda)}, block.domain, wraps_)) {
            Primitive placed = primitive;
            const Point at = block.toDrawing(piece.first);
            if (auto* ring = std::get_if<Ring>(&placed)) ring->center = at;
            if (auto* marker = std::get_if<Marker>(&placed)) marker->at = at;
            drawing_.add({role == Role::Hit ? ItemKind::Hit : ItemKind::Ray, block.level, 0, 0}, role, placed);
            break;
        }
    }

    void ray(const LevelBlock& block) {
        const bool hit = source_.hit.outcome == relief::Outcome::Hit;
        const double end = rayEnd(source_.hit, source_.steps);
        const bool known = source_.steps != nullptr && !source_.steps->empty();
        const double size = block.level == 0 ? 1 : 0.7;
        line(block, 0, end, Role::Ray, block.level == 0 ? Emphasis::Normal : Emphasis::Faint);
        const bool here = known && step(chosen_).level == block.level;
        if (here && step(chosen_).lambdaOut > step(chosen_).lambdaIn) {
            line(block, step(chosen_).lambdaIn, step(chosen_).lambdaOut, roleOf(step(chosen_).decision),
                 Emphasis::Strong);
        }
        point(block, 0, Role::Ray, Marker{{}, Shape::Dot, 6 * size});
        if (hit) point(block, end, Role::Hit, Ring{{}, 5 * size});
    }

    const PyramidSource& source_;
    const std::vector<LevelBlock>& blocks_;
    RayPath path_;
    bool wraps_;
    std::size_t chosen_;
    Drawing drawing_;
};

// Adds a level's cells to its block, once for each visible periodic copy.
void addCells(Drawing& drawing, const PyramidSource& source, const LevelBlock& block) {
    const Box period = source.overCells ? cellDomain(*source.field) : texelDomain(*source.field);
    const relief::CellGrid grid(*source.field);
    const bool repeats = source.field->address() == relief::Address::Repeat;
    const auto [i0, i1] = periodsSeen(block.domain.x0, block.domain.x1, period.x0, period.width(), repeats);
    const auto [j0, j1] = periodsSeen(block.domain.y0, block.domain.y1, period.y0, period.height(), repeats);
    for (int j = j0; j <= j1; ++j) {
        for (int i = i0; i <= i1; ++i) {
            const Box part{period.x0 + i * period.width(), period.y0 + j * period.height(),
                           period.x1 + i * period.width(), period.y1 + j * period.height()};
            Cells cells;
            // Shares ownership of the pyramid; the values are not copied.
            cells.values = {source.pyramid, &source.pyramid->level(block.level)};
            const Point shift = source.overCells ? Point{-grid.x.shift, -grid.y.shift} : Point{0, 0};
            const Point origin = block.toDrawing(Point{shift.x + i * period.width(), shift.y + j * period.height()});
            cells.x = origin.x;
            cells.y = origin.y;
            cells.cellWidth = std::ldexp(block.unitX(), block.level);
            cells.cellHeight = std::ldexp(block.unitY(), block.level);
            cells.clip = block.toDrawing(part.cut(block.domain));
            cells.print = true;
            // Printed values need more room, because the ray's marks and step numbers share the texel with them.
            constexpr double kForBoth = 28;
            if (source.hasRay) cells.printFrom = kForBoth;
            if (source.overCells && block.level == 0) {
                cells.firstI = grid.x.firstName;
                cells.firstJ = grid.y.firstName;
            }
            drawing.add({ItemKind::Level, block.level, 0, 0}, Role::HeightFill, std::move(cells));
        }
    }
}

}  // namespace

double rayEnd(const PyramidSource& source) {
    if (source.hit.outcome == relief::Outcome::Hit) return source.hit.lambda;
    if (source.steps != nullptr && !source.steps->empty())
        return std::clamp(source.steps->back().lambdaAfter, 0.0, 1.0);
    return 1;
}

PyramidPicture pyramidPicture(const PyramidSource& source, double width, double height, Point origin) {
    PyramidPicture picture;
    Arrangement arranged = arrange(source, width, height);
    picture.wraps = arranged.window.whole && source.field->address() == relief::Address::Repeat;
    picture.blocks = std::move(arranged.blocks);
    Drawing& drawing = picture.levels;
    for (LevelBlock& block : picture.blocks) {
        block.box = {block.box.x0 + origin.x, block.box.y0 + origin.y, block.box.x1 + origin.x,
                     block.box.y1 + origin.y};
        block.title = {block.title.x + origin.x, block.title.y + origin.y};
        addCells(drawing, source, block);
        drawing.add({}, Role::Frame, Rectangle{block.box, false, -0.5, 0});
        drawing.add({}, Role::Title,
                    Label{.at = block.title,
                          .text = levelTitle(*source.pyramid, block.level, block.box.width()),
                          .anchor = Anchor::BottomLeft,
                          .size = kTitleSize});
        drawing.bounds = drawing.bounds.joined(block.box).joined(
            {block.box.x0, block.box.y0 - kTitleHeight, block.box.x1, block.box.y1});
    }
    return picture;
}

Drawing pyramidMarks(const PyramidSource& source, const PyramidPicture& picture, int step) {
    if (!source.hasRay) return {};
    return Marks(source, picture, step).take();
}

}  // namespace reliefui
