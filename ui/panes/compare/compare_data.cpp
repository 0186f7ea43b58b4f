#include "panes/compare/compare_data.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "measuring/bench/pareto.h"
#include "measuring/bench/view_bench.h"
#include "panes/result/result_painting.h"
#include "rendering/base_level.h"
#include "scenario/step_sentence.h"
#include "workspace/discard.h"

namespace reliefui {

namespace {

constexpr int kRounds = 7;

class CompareText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::CompareText)
};

// All on which the frames depend, but for what methods there are.
relief::Scenario viewOf(relief::Scenario scenario) {
    scenario.pixel.reset();
    scenario.step = 0;
    scenario.comparison = {};
    scenario.ui.clear();
    scenario.breakpoints.clear();
    scenario.bookmarks.clear();
    return scenario;
}

double niceCeil(double value) {
    if (!(value > 0)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (value <= factor * power) return factor * power;
    }
    return 10 * power;
}

// Few pixels, as at edges, differ by far more than all others: those have the end of the scale.
double mostOf(const relief::FloatImage& image) {
    constexpr double kMost = 0.99;
    std::vector<float> values(image.pixels().begin(), image.pixels().end());
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(kMost * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return static_cast<double>(*at > 0 ? *at : *std::max_element(at, values.end()));
}

float largest(const relief::FloatImage& image) {
    const auto& pixels = image.pixels();
    return pixels.empty() ? 0 : *std::max_element(pixels.begin(), pixels.end());
}

std::shared_ptr<const relief::FloatImage> l1Errors(const relief::ColorImage& a, const relief::ColorImage& b) {
    const auto encoded = [](float v) { return relief::srgbFromLinear(std::clamp(v, 0.0F, 1.0F)); };
    auto errors = std::make_shared<relief::FloatImage>(a.width(), a.height());
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        float sum = 0;
        for (int c = 0; c < 3; ++c) sum += std::abs(encoded(a.pixels()[i][c]) - encoded(b.pixels()[i][c]));
        errors->pixels()[i] = sum / 3;
    }
    return errors;
}

QImage colored(const relief::FloatImage& errors, double high) {
    const Style style;  // the map of counts is the same in both themes
    QImage image(errors.width(), errors.height(), QImage::Format_RGB32);
    for (int y = 0; y < errors.height(); ++y) {
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < errors.width(); ++x) {
            const Rgba c = style.mapped(ColorMap::Count, static_cast<double>(errors(x, y)) / high);
            line[x] = qRgb(c.r, c.g, c.b);
        }
    }
    return image;
}

bool isTracer(const relief::MethodChoice& method) {
    return relief::findTracer(method.name).kind == relief::MethodKind::Tracer;
}

relief::MethodChoice exactMethod() {
    return {"exact", {}};
}

}  // namespace

const QImage& ComparedMethod::shown(const relief::Comparison& how, bool reference) const {
    const bool errors = how.mode == relief::CompareMode::Difference && !reference;
    if (!errors) return picture;
    const QImage& map = how.measure == relief::CompareMeasure::L1 ? l1Picture : flipPicture;
    return map.isNull() ? picture : map;  // coarse: the picture itself
}

std::vector<relief::MethodChoice> comparedMethods(const relief::Scenario& scenario) {
    std::vector<relief::MethodChoice> methods{scenario.method};
    const auto& others = scenario.comparison.others;
    methods.insert(methods.end(), others.begin(), others.end());
    return methods;
}

std::string comparedName(std::size_t number, const relief::MethodChoice& method) {
    return std::string(1, static_cast<char>('A' + number)) + " " + relief::shortMethodName(method);
}

bool ComparedView::isReference(const ComparedMethod& method) const {
    return scenario.comparison.reference == relief::CompareReference::MethodA ? &method == &methods.front()
                                                                              : method.method == exactMethod();
}

bool ComparedView::of(const Snapshot& snapshot) const {
    return frame == snapshot.frame && viewOf(scenario) == viewOf(snapshot.scenario) &&
           scenario.comparison.others == snapshot.scenario.comparison.others &&
           scenario.comparison.reference == snapshot.scenario.comparison.reference;
}

Comparer::Rendered& Comparer::rendered(const Snapshot& snapshot, const relief::MethodChoice& method,
                                       relief::Work& work) {
    const std::string key = relief::shortMethodName(method) + (snapshot.coarse ? "/coarse" : "");
    Rendered& at = rendered_[key];
    at.used = calls_;
    if (!at.renderer) at.renderer = std::make_unique<relief::FrameRenderer>(snapshot.maps, true);
    relief::FrameRequest request = *snapshot.request;
    request.method = relief::methodOfView(request, method);
    const std::shared_ptr<const relief::Frame> frame = at.renderer->render(request, work);
    if (frame != at.frame || at.picture.isNull()) {
        at.frame = frame;
        at.picture = makeLayer(Layer::Color, *frame, request, *snapshot.maps, work).image;
    }
    return at;
}

std::shared_ptr<const ComparedView> Comparer::view(const Snapshot& snapshot, relief::Work& work) {
    ++calls_;
    auto view = makeFreedAside<ComparedView>();
    view->scenario = snapshot.scenario;
    view->coarse = snapshot.coarse;
    view->frame = snapshot.frame;
    const relief::HeightField& field = snapshot.request->field;
    for (const relief::MethodChoice& method : comparedMethods(snapshot.scenario)) {
        ComparedMethod compared;
        compared.method = method;
        compared.name = comparedName(view->methods.size(), method);
        compared.traces = isTracer(method);
        if (view->methods.empty()) {
            compared.frame = snapshot.frame;
            compared.picture = snapshot.picture;
            compared.tracer = snapshot.tracer;
        } else if (compared.traces && !relief::supports(method, field.surface(), field.address())) {
            compared.problem = plainText(CompareText::tr("does not know this surface").toStdString());
        } else {
            try {
                const Rendered& made = rendered(snapshot, method, work);
                compared.frame = made.frame;
                compared.picture = made.picture;
                compared.tracer = made.renderer->tracer();
            } catch (const relief::InputError& error) {
                compared.problem = error.message();
            }
        }
        view->methods.push_back(std::move(compared));
    }
    const bool own = snapshot.scenario.comparison.reference == relief::CompareReference::MethodA;
    view->reference = own ? view->methods.front().name : "exact";
    if (!snapshot.coarse) {
        const std::shared_ptr<const relief::Frame> reference = own || snapshot.scenario.method == exactMethod()
                                                                   ? snapshot.frame
                                                                   : rendered(snapshot, exactMethod(), work).frame;
        measure(*view, *reference, work);
    }
    // Buffers of methods that are not looked at any more.
    constexpr int kKept = 4;
    std::erase_if(rendered_, [&](const auto& entry) { return entry.second.used + kKept < calls_; });
    return view;
}

void Comparer::measure(ComparedView& view, const relief::Frame& reference, relief::Work& work) const {
    const relief::ColorImage& right = reference.light->color;
    double l1 = 0;
    double flip = 0;
    for (ComparedMethod& method : view.methods) {
        if (!method.frame) continue;
        work.throwIfStopped();
        const relief::ColorImage& test = method.frame->light->color;
        relief::FloatImage map;
        method.error = relief::pictureError(right, test, relief::kPixelsPerDegree, map, work);
        method.equal = method.frame.get() == &reference || std::ranges::equal(right.pixels(), test.pixels());
        method.flip = std::make_shared<const relief::FloatImage>(std::move(map));
        method.l1 = l1Errors(right, test);
        l1 = std::max(l1, mostOf(*method.l1));
        flip = std::max(flip, static_cast<double>(largest(*method.flip)));
    }
    view.l1High = niceCeil(l1);
    view.flipHigh = niceCeil(flip);
    for (ComparedMethod& method : view.methods) {
        if (!method.error) continue;
        method.l1Picture = colored(*method.l1, view.l1High);
        method.flipPicture = colored(*method.flip, view.flipHigh);
    }
}

std::shared_ptr<const ComparedView> withRates(const ComparedView& view, const Snapshot& snapshot, relief::Work& work) {
    auto timed = makeFreedAside<ComparedView>(view);
    std::vector<relief::MethodChoice> methods;
    const auto ofView = [&](const ComparedMethod& method) {
        return relief::methodOfView(*snapshot.request, method.method);
    };
    for (const ComparedMethod& method : view.methods) {
        if (method.traces && !method.problem) methods.push_back(ofView(method));
    }
    const relief::RayBlock rays = relief::sampledRays(*snapshot.frame, kComparedRays);
    if (methods.empty() || rays.size() == 0) return timed;
    const std::vector<relief::BenchRow> rows =
        relief::benchRaysOfView(snapshot.request->field, rays, methods, kRounds, *snapshot.maps, work);
    timed->rays = rays.size();
    timed->rounds = kRounds;
    for (ComparedMethod& method : timed->methods) {
        for (const relief::BenchRow& row : rows) {
            if (relief::shortMethodName(row.method) != relief::shortMethodName(ofView(method))) continue;
            method.rate = row.rate / 1e6;
            method.steps = row.stepsMean;
        }
    }
    return timed;
}

CompareSource compareSource(const ComparedView& view, const relief::Comparison& how, std::size_t shown) {
    CompareSource source;
    source.mode = how.mode;
    source.measure = how.measure;
    relief::Comparison shape = how;
    shape.others.resize(view.methods.empty() ? 0 : view.methods.size() - 1);
    source.dividers = relief::dividersOf(shape);
    source.shown = view.methods.empty() ? 0 : shown % view.methods.size();
    source.aspect = static_cast<double>(view.scenario.height) / view.scenario.width;
    source.high = how.measure == relief::CompareMeasure::L1 ? view.l1High : view.flipHigh;
    source.reference = view.reference;
    source.rays = view.rays;
    source.rounds = view.rounds;
    for (const ComparedMethod& method : view.methods) {
        CompareTile tile;
        tile.name = method.name;
        tile.missing = method.problem;
        tile.reference = view.isReference(method);
        tile.equal = method.equal;
        tile.traces = method.traces;
        if (method.error) {
            tile.rmse = method.error->rmse;
            tile.psnr = method.error->psnr;
            tile.flip = method.error->flip;
        }
        tile.rate = method.rate;
        tile.steps = method.steps;
        source.tiles.push_back(std::move(tile));
    }
    return source;
}

QString compareReadout(const ComparedView& view, const Snapshot& snapshot, std::size_t number,
                       relief::PixelChoice pixel) {
    const ComparedMethod& method = view.methods[number];
    QString text = QString::fromStdString(method.name);
    if (!method.frame) return text;
    const relief::Frame& frame = *method.frame;
    const int x = std::clamp(pixel.x * frame.width / snapshot.scenario.width, 0, frame.width - 1);
    const int y = std::clamp(pixel.y * frame.height / snapshot.scenario.height, 0, frame.height - 1);
    const std::size_t i = frame.index(x, y);
    const auto fixed = [](double value, int decimals) {
        return QString::fromStdString(relief::fixedText(value, decimals));
    };
    if (frame.rays->polygon[i] == relief::kNoPolygon) return text + QStringLiteral(": ") + outcomeTitle({});
    const relief::Hit hit = frame.hits->hits[i];
    text += QStringLiteral(": ");
    text += hit.outcome == relief::Outcome::Hit
                ? CompareText::tr("(%1, %2) λ %3").arg(fixed(hit.s, 2), fixed(hit.t, 2), fixed(hit.lambda, 3))
                : outcomeTitle(hit.outcome);
    if (method.traces && method.tracer) {
        relief::RayBlock ray;
        ray.push(frame.rays->rays[i]);
        relief::HitBlock again;
        relief::BlockCounts counts;
        relief::Work work(1);
        method.tracer->trace(ray, again, counts, work);
        text += CompareText::tr(", steps: %1").arg(again.steps[0]);
    }
    if (method.flip) text += QStringLiteral(", FLIP %1").arg(fixed(static_cast<double>((*method.flip)(x, y)), 3));
    return text;
}

}  // namespace reliefui
