#include "panes/pyramid/slab_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "painting/text_width.h"
#include "painting/vtk_text.h"
#include "panes/pyramid/slab_actors.h"
#include "panes/pyramid/slab_piles.h"
#include "panes/ray_geometry.h"
#include "workspace/pause_log.h"

namespace reliefui {

namespace {

constexpr double kThick = 0.02;        // of a slab that is 1 wide
constexpr double kTitleSize = 0.85;    // of the text's
constexpr double kLine = 1.4;          // of the titles, of their size
constexpr double kAbove = 0.004;       // marks over their slab
constexpr std::size_t kMostWay = 400;  // steps around the chosen one

using Place = Turntable::Place;

Point middleOf(const Primitive& primitive) {
    if (const auto* const box = std::get_if<Rectangle>(&primitive)) return box->box.center();
    if (const auto* const line = std::get_if<Polyline>(&primitive)) {
        if (line->points.empty()) return {NAN, NAN};
        const Point& a = line->points.front();
        const Point& b = line->points.back();
        return {(a.x + b.x) / 2, (a.y + b.y) / 2};
    }
    if (const auto* const ring = std::get_if<Ring>(&primitive)) return ring->center;
    return {NAN, NAN};
}

// All as wide as deep at most.
double unitOf(const LevelBlock& block) {
    return 1 / std::max(block.box.width(), block.box.height());
}

std::string titleOf(const LevelBlock& block, const Drawing& levels, relief::Language language) {
    for (const Item& item : levels.items) {
        const auto* const label = std::get_if<Label>(&item.primitive);
        if (label == nullptr || item.role != Role::Title || !(label->at == block.title)) continue;
        return relief::sentence(label->text, language);
    }
    return {};
}

}  // namespace

SlabScene::SlabScene() : renderer_(vtkSmartPointer<vtkRenderer>::New()) {
    renderer_->UseFXAAOn();
    camera.lookAlong(0, 1);
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

void SlabScene::layOut(const PyramidParts& parts, double width, double height) {
    slabs_.clear();
    firsts_.clear();
    const double text = style_.textPixels(kTitleSize);
    std::vector<std::vector<SlabSize>> sizes;
    for (const PyramidPart& part : parts.parts) {
        sizes.emplace_back();
        for (const LevelBlock& block : part.picture.blocks) {
            const double unit = unitOf(block);
            const double wide =
                style_.pixelsPerPoint() * textWidth(titleOf(block, part.picture.levels, style_.language), kTitleSize);
            sizes.back().push_back(
                {block.box.width() * unit, block.box.height() * unit, wide + text / 2, kLine * text});
        }
    }
    const SlabPiles piles = slabPiles(sizes, width, height);
    for (std::size_t n = 0; n < parts.parts.size(); ++n) {
        firsts_.push_back(slabs_.size());
        const std::vector<LevelBlock>& blocks = parts.parts[n].picture.blocks;
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            const SlabPlace& place = piles.places[n][k];
            const SlabSize& size = sizes[n][k];
            slabs_.push_back({blocks[k], place.x, 0, place.z, unitOf(blocks[k]), place.pile,
                              size.titleWidth / piles.scale, size.titleHeight / piles.scale});
        }
    }
}

const SlabScene::Slab* SlabScene::slabOf(Point drawing) const {
    for (const Slab& slab : slabs_) {
        if (slab.block.box.grown(1e-6).contains(drawing)) return &slab;
    }
    return nullptr;
}

bool SlabScene::show(const PyramidParts& parts, const Style& style, double width, double height) {
    const PauseLog::Part part("pyramid: slabs");
    style_ = style;
    const Rgba ground = style.background();
    renderer_->SetBackground(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    renderer_->RemoveAllViewProps();
    marks_.clear();
    const std::vector<Slab> before = slabs_;
    layOut(parts, width, height);
    for (std::size_t n = 0; n < parts.parts.size(); ++n) {
        const std::size_t end = n + 1 < firsts_.size() ? firsts_[n + 1] : slabs_.size();
        for (std::size_t k = firsts_[n]; k < end; ++k) addSlab(slabs_[k], parts.parts[n]);
    }
    return std::ranges::equal(before, slabs_, {}, &Slab::pile, &Slab::pile);
}

void SlabScene::letGo() {
    renderer_->RemoveAllViewProps();
    marks_.clear();
}

void SlabScene::addSlab(const Slab& slab, const PyramidPart& part) {
    for (const Item& item : part.picture.levels.items) {
        const auto* const cells = std::get_if<Cells>(&item.primitive);
        if (cells == nullptr || item.id.level != slab.block.level || cells->clip.empty()) continue;
        const Box& c = cells->clip;
        renderer_->AddActor(
            slabPicture(*cells, style_,
                        {slab.at({c.x0, c.y0}), slab.at({c.x1, c.y0}), slab.at({c.x1, c.y1}), slab.at({c.x0, c.y1})}));
    }
    // A little thickness, so that it is one body.
    const Box& b = slab.block.box;
    const std::array<Point, 4> corners{Point{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Point& from = corners[k];
        const Point& to = corners[(k + 1) % 4];
        auto side = flatActor(quadOf({slab.at(from), slab.at(to), slab.at(to, -kThick), slab.at(from, -kThick)}));
        const Rgba grey = style_.color(Role::Frame);
        side->GetProperty()->SetColor(grey.r / 255.0, grey.g / 255.0, grey.b / 255.0);
        renderer_->AddActor(side);
    }
    addTitle(slab, part.picture.levels);
}

// Below its front edge.
void SlabScene::addTitle(const Slab& slab, const Drawing& levels) {
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput(titleOf(slab.block, levels, style_.language).c_str());
    text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    const Place at = slab.at({slab.block.box.x0, slab.block.box.y1}, -kThick);
    text->GetPositionCoordinate()->SetValue(at[0], at[1], at[2]);
    setText(text->GetTextProperty(), style_.text(), style_.textPixels(kTitleSize));
    text->GetTextProperty()->SetVerticalJustificationToTop();
    const Rgba ground = style_.background();
    text->GetTextProperty()->SetBackgroundColor(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    text->GetTextProperty()->SetBackgroundOpacity(0.7);
    renderer_->AddActor2D(text);
}

void SlabScene::addLines(const std::vector<std::pair<Place, Place>>& lines, Rgba color, double width) {
    if (lines.empty()) return;
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& [from, to] : lines) {
        const vtkIdType ends[2] = {points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
        cells->InsertNextCell(2, ends);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    auto actor = flatActor(data);
    actor->GetProperty()->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
    actor->GetProperty()->SetOpacity(color.a / 255.0);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width * style_.screenPixelsPerPoint));
    renderer_->AddActor(actor);
    marks_.emplace_back(actor);
}

// From step to step: on a slab, and up and down between slabs; thin from pile to pile.
void SlabScene::addWay(const PyramidPart& part, const std::vector<const Slab*>& slabs, std::size_t chosen) {
    const std::vector<relief::Step>& steps = *part.source.steps;
    const RayPath path(*part.source.field, part.source.ray);
    std::vector<std::pair<Place, Place>> before;
    std::vector<std::pair<Place, Place>> across;
    std::vector<std::pair<Place, Place>> after;
    std::optional<Place> last;
    int lastPile = 0;
    const std::size_t first = chosen > kMostWay ? chosen - kMostWay : 0;
    for (std::size_t k = first; k < std::min(steps.size(), chosen + kMostWay); ++k) {
        const relief::Step& step = steps[k];
        const double lambda = std::clamp((step.lambdaIn + step.lambdaOut) / 2, 0.0, 1.0);
        std::optional<Place> here;
        if (step.level >= 0 && step.level < static_cast<int>(slabs.size()) && std::isfinite(lambda)) {
            const Slab& slab = *slabs[static_cast<std::size_t>(step.level)];
            const auto pieces =
                wrapped(Segment{path.at(lambda), path.at(lambda)}, slab.block.domain, part.picture.wraps);
            if (!pieces.empty()) here = slab.at(slab.block.toDrawing(pieces.front().first), 3 * kAbove);
        }
        const int pile = here ? slabs[static_cast<std::size_t>(step.level)]->pile : lastPile;
        if (last && here) (k > chosen ? after : pile != lastPile ? across : before).emplace_back(*last, *here);
        last = here;
        lastPile = pile;
    }
    addLines(after, style_.color({{}, Role::Ray, Emphasis::Faint, Polyline{}, {}}), 1);
    addLines(across, style_.color(Role::Ray), 1);
    addLines(before, style_.color(Role::Ray), 2.5);
}

void SlabScene::addMark(const Item& item, const Slab& slab) {
    const Stroke stroke = style_.stroke(item);
    std::vector<std::pair<Place, Place>> lines;
    if (const auto* const box = std::get_if<Rectangle>(&item.primitive)) {
        const Box b = box->box.cut(slab.block.box);
        const std::array<Place, 4> c{slab.at({b.x0, b.y0}, 2 * kAbove), slab.at({b.x1, b.y0}, 2 * kAbove),
                                     slab.at({b.x1, b.y1}, 2 * kAbove), slab.at({b.x0, b.y1}, 2 * kAbove)};
        for (std::size_t k = 0; k < 4; ++k) lines.emplace_back(c[k], c[(k + 1) % 4]);
        if (box->fill) {
            auto actor = flatActor(quadOf(c));
            const Rgba fill = style_.fill(item);
            actor->GetProperty()->SetColor(fill.r / 255.0, fill.g / 255.0, fill.b / 255.0);
            actor->GetProperty()->SetOpacity(fill.a / 255.0);
            renderer_->AddActor(actor);
            marks_.emplace_back(actor);
        }
    } else if (const auto* const line = std::get_if<Polyline>(&item.primitive)) {
        for (std::size_t k = 1; k < line->points.size(); ++k) {
            lines.emplace_back(slab.at(line->points[k - 1], 2 * kAbove), slab.at(line->points[k], 2 * kAbove));
        }
    }
    if (const auto* const ring = std::get_if<Ring>(&item.primitive)) {
        constexpr int kSides = 24;
        constexpr double kRadius = 0.02;
        const auto at = [&](int k) {
            const double turn = 2 * std::numbers::pi * k / kSides;
            const double radius = kRadius / slab.unit;
            const Point& c = ring->center;
            return slab.at({c.x + radius * std::cos(turn), c.y + radius * std::sin(turn)}, 4 * kAbove);
        };
        for (int k = 0; k < kSides; ++k) lines.emplace_back(at(k), at(k + 1));
    }
    addLines(lines, stroke.color, stroke.width / style_.screenPixelsPerPoint);
}

void SlabScene::showStep(const PyramidParts& parts, int step) {
    const PauseLog::Part timed("pyramid: marks on slabs");
    for (const auto& prop : marks_) renderer_->RemoveViewProp(prop);
    marks_.clear();
    for (const Slab& slab : slabs_) {
        const Box& b = slab.block.box;
        const std::array<Point, 5> rim{Point{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}, {b.x0, b.y0}};
        std::vector<std::pair<Place, Place>> edges;
        for (std::size_t k = 1; k < rim.size(); ++k)
            edges.emplace_back(slab.at(rim[k - 1], kAbove), slab.at(rim[k], kAbove));
        addLines(edges, style_.color(Role::Frame), 1);
    }
    const Drawing marks = partsMarks(parts, step);
    for (const Item& item : marks.items) {
        const Slab* const slab = slabOf(middleOf(item.primitive));
        if (slab == nullptr) continue;
        addMark(item, *slab);
    }
    for (std::size_t n = 0; n < parts.parts.size() && n < firsts_.size(); ++n) {
        const PyramidPart& part = parts.parts[n];
        if (!part.source.hasRay || part.source.steps == nullptr || part.source.steps->empty()) continue;
        std::vector<const Slab*> slabs;
        for (std::size_t k = 0; k < part.picture.blocks.size(); ++k) slabs.push_back(&slabs_[firsts_[n] + k]);
        const auto chosen =
            static_cast<std::size_t>(std::clamp(step, 0, static_cast<int>(part.source.steps->size()) - 1));
        addWay(part, slabs, chosen);
    }
}

std::array<double, 2> SlabScene::toPixel(std::size_t part, int level, Point texel) const {
    const Slab& slab = slabs_.at(firsts_.at(part) + static_cast<std::size_t>(level));
    const Place at = slab.at(slab.block.toDrawing(texel), 2 * kAbove);
    auto coordinate = vtkSmartPointer<vtkCoordinate>::New();
    coordinate->SetCoordinateSystemToWorld();
    coordinate->SetValue(at[0], at[1], at[2]);
    const double* const pixel = coordinate->GetComputedDoubleDisplayValue(renderer_);
    return {pixel[0], pixel[1]};
}

std::optional<Point> SlabScene::drawingAt(double x, double y) const {
    double ends[2][4];
    for (int k = 0; k < 2; ++k) {
        renderer_->SetDisplayPoint(x, y, k);
        renderer_->DisplayToWorld();
        renderer_->GetWorldPoint(ends[k]);
        for (int c = 0; c < 3; ++c) ends[k][c] /= ends[k][3];
    }
    const double down = ends[1][2] - ends[0][2];
    if (down == 0) return std::nullopt;
    std::optional<Point> found;
    double nearest = 2;
    for (const Slab& slab : slabs_) {
        const double f = (slab.z - ends[0][2]) / down;
        const Point at{slab.block.box.x0 + (ends[0][0] + f * (ends[1][0] - ends[0][0]) - slab.x) / slab.unit,
                       slab.block.box.y0 - (ends[0][1] + f * (ends[1][1] - ends[0][1]) - slab.y) / slab.unit};
        if (f < 0 || f >= nearest || !slab.block.box.contains(at)) continue;
        nearest = f;
        found = at;
    }
    return found;
}

void SlabScene::showAll(double aspect) {
    if (slabs_.empty()) return;
    std::vector<Place> places;
    for (const Slab& slab : slabs_) {
        const Box& b = slab.block.box;
        for (const Point& p : {Point{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}})
            places.push_back(slab.at(p));
        Place title = slab.at({b.x0, b.y1}, -kThick - slab.titleHeight / std::cos(Turntable::kElevation));
        places.push_back(title);
        title[0] += slab.titleWidth;
        places.push_back(title);
    }
    camera.fit(places, aspect);
}

void SlabScene::place() {
    camera.apply(renderer_->GetActiveCamera());
    renderer_->ResetCameraClippingRange();
}

}  // namespace reliefui
