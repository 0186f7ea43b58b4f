#include "panes/pyramid/slab_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "painting/text_width.h"
#include "painting/view_map.h"
#include "painting/vtk_text.h"
#include "scenario/step_sentence.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kTitleSize = 0.85;  // relative to the style's text size
constexpr double kLine = 1.4;        // line height, relative to the titles' size
// Brightness of a slab's sides relative to its top; the sides facing left and right are darkest.
constexpr double kFront = 0.72;
constexpr double kSide = 0.5;
constexpr double kHidden = 0.4;      // opacity of the ray where slabs hide it
constexpr double kBeforeAll = -2e5;  // depth offset by which marks are drawn in front of everything
constexpr double kMostLines = 40;    // of a level's grid, per side
// Least side of a slab with an outline, in points. Seen from above, the slab's depth is about half of that, and its
// outline would cover its colour.
constexpr double kLeastOutlined = 5;

using Place = Turntable::Place;

// Quadrilaterals, each with its colour.
class Faces {
  public:
    Faces() { colors_->SetNumberOfComponents(3); }

    void add(const std::array<Place, 4>& corners, Rgba color, double shade) {
        vtkIdType ids[4];
        for (std::size_t k = 0; k < 4; ++k) ids[k] = points_->InsertNextPoint(corners[k].data());
        cells_->InsertNextCell(4, ids);
        colors_->InsertNextTuple3(color.r * shade, color.g * shade, color.b * shade);
    }
    // Adds the top and sides of a box; the bottom is never visible.
    void box(const Place& low, const Place& high, Rgba color) {
        const auto [x0, y0, z0] = low;
        const auto [x1, y1, z1] = high;
        add({Place{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}}, color, 1);
        if (!(z1 > z0)) return;
        add({Place{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}}, color, kFront);
        add({Place{x0, y1, z0}, {x1, y1, z0}, {x1, y1, z1}, {x0, y1, z1}}, color, kFront);
        add({Place{x0, y0, z0}, {x0, y1, z0}, {x0, y1, z1}, {x0, y0, z1}}, color, kSide);
        add({Place{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}}, color, kSide);
    }
    void disk(const Place& middle, double radius, Rgba color) {
        constexpr int kQuarters = 16;
        const auto at = [&](int k) {
            const double turn = std::numbers::pi * k / kQuarters;
            return Place{middle[0] + radius * std::cos(turn), middle[1] + radius * std::sin(turn), middle[2]};
        };
        for (int k = 0; k < 2 * kQuarters; k += 2) add({middle, at(k), at(k + 1), at(k + 2)}, color, 1);
    }
    vtkSmartPointer<vtkActor> actor() const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetPolys(cells_);
        data->GetCellData()->SetScalars(colors_);
        return flat(data);
    }
    // Without lighting, because the colours encode values.
    static vtkSmartPointer<vtkActor> flat(const vtkSmartPointer<vtkPolyData>& data) {
        auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
        mapper->SetInputData(data);
        auto actor = vtkSmartPointer<vtkActor>::New();
        actor->SetMapper(mapper);
        actor->GetProperty()->SetLighting(false);
        return actor;
    }

  private:
    vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
    vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
    vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

}  // namespace

SlabScene::SlabScene() : renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    renderer_->UseFXAAOn();
    lookFromHome();
}

SlabScene::~SlabScene() = default;

vtkRenderer* SlabScene::renderer() const {
    return renderer_;
}

void SlabScene::addTo(vtkRenderWindow* window) const {
    window->AddRenderer(renderer_);
}

void SlabScene::takeFrom(vtkRenderWindow* window) const {
    window->RemoveRenderer(renderer_);
}

void SlabScene::lookFromHome() {
    camera.lookAlong(tower_.viewDirection().x, tower_.viewDirection().y);
}

void SlabScene::show(const PyramidParts& parts, const Style& style) {
    const PauseLog::Part timed("pyramid: slabs");
    style_ = style;
    parts_ = &parts;
    const Rgba ground = style.background();
    renderer_->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    renderer_->RemoveAllViewProps();
    marks_.clear();
    outlines_.clear();
    tower_ = SlabTower(parts);
    for (std::size_t n = 0; n < parts.parts.size(); ++n) {
        addBodies(n);
        addGround(n);
    }
    addTitles();
}

void SlabScene::releaseContents() {
    renderer_->RemoveAllViewProps();
    marks_.clear();
    outlines_.clear();
    tower_ = {};
    parts_ = nullptr;
}

void SlabScene::addBodies(std::size_t part) {
    Faces faces;
    std::vector<std::vector<Line>> edges(static_cast<std::size_t>(tower_.top()) + 1);
    for (const Slab& slab : tower_.slabs()) {
        if (slab.part != part) continue;
        const Box& g = slab.ground;
        const Rgba color = style_.cell(ColorMap::Height, static_cast<double>(slab.value), parts_->heights.scale);
        faces.box(tower_.at(part, {g.x0, g.y1}, slab.foot), tower_.at(part, {g.x1, g.y0}, slab.top), color);
        const double across = tower_.domain(part).width() / g.width();
        if (across > kMostLines) continue;
        for (const Line& line : rim(part, g, slab.top)) edges[static_cast<std::size_t>(slab.level)].push_back(line);
    }
    renderer_->AddActor(faces.actor());
    for (std::size_t level = 0; level < edges.size(); ++level) {
        if (edges[level].empty()) continue;
        outlines_.emplace_back(std::ldexp(1.0, static_cast<int>(level)),
                               addLines(edges[level], style_.color(Role::Frame), 0.5));
    }
}

std::vector<SlabScene::Line> SlabScene::rim(std::size_t part, const Box& b, double z) const {
    const std::array<Point, 5> corners{Point{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}, {b.x0, b.y0}};
    std::vector<Line> lines;
    for (std::size_t k = 1; k < corners.size(); ++k)
        lines.emplace_back(tower_.at(part, corners[k - 1], z), tower_.at(part, corners[k], z));
    return lines;
}

// Adds the frame of each level and the lines between slabs, also where no slabs are drawn.
void SlabScene::addGround(std::size_t part) {
    const Box& domain = tower_.domain(part);
    const PyramidPart& of = parts_->parts[part];
    std::vector<Line> frames;
    std::vector<Line> grid;
    for (int level = 0; level <= std::min(tower_.top() + 1, tower_.levels() - 1); ++level) {
        const double z = tower_.foot(level);
        for (const Line& line : rim(part, domain, z)) frames.push_back(line);
        const double side = std::ldexp(1.0, level);
        if (level == 0 || level > tower_.top() || domain.width() > kMostLines * side) continue;
        for (const Item& item : of.picture.levels.items) {
            const auto* const cells = std::get_if<Cells>(&item.primitive);
            if (cells == nullptr || item.id.level != level) continue;
            const LevelBlock& block = of.picture.blocks[static_cast<std::size_t>(level)];
            const CellRange seen = visibleCells(*cells, cells->clip);
            for (int j = seen.j0; j < seen.j1; ++j) {
                for (int i = seen.i0; i < seen.i1; ++i) {
                    const Box cell = block.toTexels(cellBox(*cells, i, j));
                    const auto covers = [&](const Slab& slab) {
                        return slab.part == part && slab.level == level && slab.ground.contains(cell.center());
                    };
                    if (std::any_of(tower_.slabs().begin(), tower_.slabs().end(), covers)) continue;
                    grid.emplace_back(tower_.at(part, {cell.x0, cell.y0}, z), tower_.at(part, {cell.x1, cell.y0}, z));
                    grid.emplace_back(tower_.at(part, {cell.x0, cell.y0}, z), tower_.at(part, {cell.x0, cell.y1}, z));
                }
            }
        }
    }
    const Rgba grey = style_.color(Role::Frame);
    addLines(frames, grey, 1);
    addLines(grid, {grey.r, grey.g, grey.b, 110}, 0.5);
}

namespace {

// The corner that comes first in this direction (X to the right, Y upwards; texel rows increase downwards).
Point firstCorner(const Box& d, Point direction) {
    const std::array<Point, 4> corners{Point{d.x0, d.y0}, {d.x1, d.y0}, {d.x1, d.y1}, {d.x0, d.y1}};
    return *std::min_element(corners.begin(), corners.end(), [&](Point a, Point b) {
        return a.x * direction.x - a.y * direction.y < b.x * direction.x - b.y * direction.y;
    });
}

}  // namespace

// Viewed along (x, y), the right-hand direction is (y, -x).
Point SlabScene::leftCorner(std::size_t part) const {
    return firstCorner(tower_.domain(part), {tower_.viewDirection().y, -tower_.viewDirection().x});
}

Point SlabScene::nearCorner(std::size_t part) const {
    return firstCorner(tower_.domain(part), tower_.viewDirection());
}

vtkSmartPointer<vtkTextActor> SlabScene::words(const std::string& content) const {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput(content.c_str());
    setText(text->GetTextProperty(), style_.text(), style_.textPixels(kTitleSize));
    return text;
}

void SlabScene::addWords(const std::string& content, const Place& at, bool beside) {
    const std::string spaced = beside ? content + "  " : content;
    auto text = words(spaced);
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    text->GetPositionCoordinate()->SetValue(at[0], at[1], at[2]);
    if (beside) {
        text->GetTextProperty()->SetJustificationToRight();
        text->GetTextProperty()->SetVerticalJustificationToCentered();
        titleWidth_ = std::max(titleWidth_, style_.pixelsPerPoint() * textWidth(spaced, kTitleSize));
    } else {
        text->GetTextProperty()->SetVerticalJustificationToTop();
    }
    renderer_->AddActor2D(text);
}

// Adds titles left of each level, below each of several pyramids, and the scales in the corner.
void SlabScene::addTitles() {
    titleWidth_ = 0;
    const int last = tower_.levels() - 1;
    for (int level = 0; level <= std::min(tower_.top() + 1, last) && !parts_->parts.empty(); ++level) {
        const int drawn = tower_.drawnAs(0, level);
        QString title = tr("level %1 · %2 × %2 texels").arg(level).arg(qint64{1} << level);
        if (drawn > level) title = tr("level %1, drawn as level %2").arg(level).arg(drawn);
        if (level > tower_.top()) {
            title = level == last ? tr("level %1, not drawn").arg(last)
                                  : tr("levels %1 to %2, not drawn").arg(level).arg(last);
        }
        addWords(title.toStdString(), tower_.at(0, leftCorner(0), tower_.foot(level)), true);
    }
    if (parts_->parts.empty()) return;
    const int halved = static_cast<int>(std::lround(1 / tower_.factor()));
    const QString apart = QString::fromStdString(relief::numberText(tower_.apart(), 3));
    QString note = tr("levels %1 texels apart").arg(apart) + QLatin1Char('\n') +
                   (halved > 1 ? tr("heights × 1/%1").arg(halved) : tr("heights to scale"));
    for (std::size_t n = 0; n < parts_->parts.size(); ++n) {
        const relief::PyramidKind kind = parts_->parts[n].source.pyramid->kind();
        const QString name = kind == relief::PyramidKind::Max    ? tr("maxima")
                             : kind == relief::PyramidKind::Mean ? tr("means")
                                                                 : tr("minima");
        if (parts_->parts.size() == 1) note = name + QStringLiteral(" · ") + note;
        if (parts_->parts.size() > 1) addWords(name.toStdString(), tower_.at(n, nearCorner(n), 0), false);
    }
    auto corner = words(note.toStdString());
    const double margin = style_.textPixels(kTitleSize) / 2;
    corner->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    corner->GetPositionCoordinate()->SetValue(margin, margin, 0);
    renderer_->AddActor2D(corner);
}

vtkSmartPointer<vtkActor> SlabScene::addLines(const std::vector<Line>& lines, Rgba color, double width, bool before) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& [from, to] : lines) {
        const vtkIdType ends[2] = {points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
        cells->InsertNextCell(2, ends);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    auto actor = Faces::flat(data);
    // Depth offsets that draw lines in front of the face they lie on, or in front of everything.
    constexpr double kOnFace = -8;
    auto* const mapper = actor->GetMapper();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, before ? kBeforeAll : kOnFace);
    actor->GetProperty()->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
    actor->GetProperty()->SetOpacity(color.a / 255.0);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width * style_.screenPixelsPerPoint));
    renderer_->AddActor(actor);
    return actor;
}

void SlabScene::keep(const vtkSmartPointer<vtkActor>& mark) {
    marks_.emplace_back(mark);
}

void SlabScene::addMarks(std::size_t part, std::size_t chosen) {
    const std::vector<relief::Step>& steps = *parts_->parts[part].source.steps;
    for (const SlabMark& mark : tower_.marks(part, chosen)) {
        const Item item{
            {}, roleOf(steps[mark.step].decision), mark.later ? Emphasis::Faint : Emphasis::Normal, Rectangle{}, {}};
        const std::vector<Line> lines = rim(part, mark.ground, mark.top);
        keep(addLines(lines, style_.color(item), mark.chosen ? 4 : 2));
        if (mark.chosen) keep(addLines(lines, style_.color(Role::Highlight), 1.5));
    }
}

void SlabScene::addRayPath(std::size_t part, std::size_t chosen) {
    std::vector<std::pair<SlabStretch, std::vector<Line>>> kinds;
    for (const SlabStretch& stretch : tower_.rayPath(part, chosen)) {
        const auto same = [&](const auto& kind) {
            return kind.first.role == stretch.role && kind.first.later == stretch.later;
        };
        auto at = std::find_if(kinds.begin(), kinds.end(), same);
        if (at == kinds.end()) at = kinds.insert(at, {stretch, {}});
        at->second.emplace_back(stretch.from, stretch.to);
    }
    for (const auto& [kind, lines] : kinds) {
        const double width = kind.later ? 1 : kind.role == Role::Ray ? 2.5 : 3;
        Rgba color = style_.color({{}, kind.role, kind.later ? Emphasis::Faint : Emphasis::Normal, Polyline{}, {}});
        keep(addLines(lines, color, width));
        if (kind.later) continue;
        color.a = static_cast<std::uint8_t>(kHidden * color.a);
        keep(addLines(lines, color, width, true));
    }
    const auto end = tower_.end(part);
    if (!end) return;
    // A horizontal ring, made of disks on top of each other.
    constexpr double kRadius = 0.018;
    const double radius = kRadius * std::max(tower_.domain(part).width(), tower_.domain(part).height());
    const Rgba ground = style_.background();
    double nearer = kBeforeAll;
    for (const auto& [size, color] : {std::pair(1.4, ground), {1.0, style_.color(Role::Hit)}, {0.55, ground}}) {
        Faces disk;
        disk.disk(*end, radius * size, color);
        auto actor = disk.actor();
        auto* const mapper = actor->GetMapper();
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, nearer);
        nearer *= 1.5;
        renderer_->AddActor(actor);
        keep(actor);
    }
}

void SlabScene::showStep(int step) {
    const PauseLog::Part timed("pyramid: marks on slabs");
    for (const auto& prop : marks_) renderer_->RemoveViewProp(prop);
    marks_.clear();
    if (parts_ == nullptr) return;
    for (std::size_t n = 0; n < parts_->parts.size(); ++n) {
        const PyramidSource& source = parts_->parts[n].source;
        if (!source.hasRay || source.steps == nullptr || source.steps->empty()) continue;
        const auto chosen = static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(source.steps->size()) - 1));
        addMarks(n, chosen);
        addRayPath(n, chosen);
    }
}

std::array<double, 2> SlabScene::toPixel(std::size_t part, int level, Point texel) const {
    double z = tower_.foot(level);
    for (const Slab& slab : tower_.slabs()) {
        if (slab.part == part && slab.level == level && slab.ground.contains(texel)) z = slab.top;
    }
    const Place at = tower_.at(part, texel, z);
    auto coordinate = vtkSmartPointer<vtkCoordinate>::New();
    coordinate->SetCoordinateSystemToWorld();
    coordinate->SetValue(at[0], at[1], at[2]);
    const double* const pixel = coordinate->GetComputedDoubleDisplayValue(renderer_);
    return {pixel[0], pixel[1]};
}

std::optional<Point> SlabScene::drawingAt(double x, double y) const {
    Place ends[2];
    for (int k = 0; k < 2; ++k) {
        double world[4];
        renderer_->SetDisplayPoint(x, y, k);
        renderer_->DisplayToWorld();
        renderer_->GetWorldPoint(world);
        ends[k] = {world[0] / world[3], world[1] / world[3], world[2] / world[3]};
    }
    const SlabTower::Intersection met = tower_.intersect(ends[0], ends[1]);
    if (met.slab == nullptr) return std::nullopt;
    const std::vector<LevelBlock>& blocks = parts_->parts[met.slab->part].picture.blocks;
    return blocks[static_cast<std::size_t>(met.slab->level)].toDrawing(met.texel);
}

void SlabScene::showAll(double width, double height) {
    if (tower_.slabs().empty()) return;
    std::vector<Place> places;
    for (std::size_t n = 0; n < parts_->parts.size(); ++n) {
        const Box& d = tower_.domain(n);
        const double high = std::max(tower_.heightOver(tower_.top(), 1), tower_.foot(tower_.levels() - 1));
        for (const double z : {0.0, high}) {
            for (const Point& p : {Point{d.x0, d.y0}, {d.x1, d.y0}, {d.x1, d.y1}, {d.x0, d.y1}})
                places.push_back(tower_.at(n, p, z));
        }
    }
    // Leaves room for the titles at the side and for the lines in the corner.
    const double line = kLine * style_.textPixels(kTitleSize);
    camera.fit(places, std::max(width - titleWidth_, width / 4) / std::max(height, 1.0));
    const double beside = std::min(titleWidth_, width * 3 / 4);
    camera.zoom(std::max(height - 3 * line, height / 2) / height, 0, 0);
    camera.move(beside / 2, -1.2 * line, height);
}

void SlabScene::place() {
    camera.apply(renderer_->GetActiveCamera());
    const double pixelsPerTexel = renderer_->GetSize()[1] / camera.viewHeight();
    for (const auto& [side, outline] : outlines_) {
        outline->SetVisibility(side * pixelsPerTexel >= kLeastOutlined * style_.pixelsPerPoint());
    }
    renderer_->ResetCameraClippingRange();
}

}  // namespace reliefui
