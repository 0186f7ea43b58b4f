#include "panes/compare/compare_data.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "painting/style.h"
#include "workspace/discard.h"

namespace reliefui {

namespace {

class CompareText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::CompareText)
};

using relief::CompareSubject;

// The scenario of a picture, reduced to what the picture depends on, with this choice in place of the scenario's own.
relief::Scenario shownBy(const relief::Scenario& whole, const relief::MethodChoice& choice) {
    const CompareSubject subject = whole.comparison.subject;
    relief::Scenario scenario = relief::varied(whole, subject, choice);
    scenario.pixel.reset();
    scenario.step = 0;
    scenario.comparison = {};
    scenario.ui.clear();
    scenario.breakpoints.clear();
    scenario.bookmarks.clear();
    scenario.other = {};
    if (subject == CompareSubject::Heights) scenario.comparison.heights = {choice};
    return scenario;
}

bool rates(CompareSubject subject, const relief::MethodChoice& choice) {
    if (subject == CompareSubject::Filters) return choice.name != relief::kSupersample;
    return subject == CompareSubject::Methods && relief::findTracer(choice.name).kind == relief::MethodKind::Tracer;
}

}  // namespace

relief::MethodChoice comparedReference(const relief::Scenario& scenario) {
    return scenario.comparison.reference == relief::CompareReference::MethodA
               ? relief::ownVariation(scenario, scenario.comparison.subject)
               : relief::referenceVariation(scenario);
}

std::string comparedReferenceName(const relief::Scenario& scenario) {
    const relief::MethodChoice choice = comparedReference(scenario);
    const CompareSubject subject = scenario.comparison.subject;
    if (scenario.comparison.reference == relief::CompareReference::MethodA) return comparedName(0, subject, choice);
    if (subject != CompareSubject::Filters) return choice.name;
    const std::string samples = choice.options.at(relief::kSamples);
    return choice.name + " " + samples + " × " + samples;
}

const QImage& ComparedPicture::shown(const relief::Comparison& how, bool reference) const {
    const bool errors = how.mode == relief::CompareMode::Difference && !reference;
    if (!errors) return picture;
    const QImage& map = how.measure == relief::CompareMeasure::L1 ? l1Picture : flipPicture;
    return map.isNull() ? picture : map;  // while coarse or not measured yet, the picture itself
}

std::string comparedName(std::size_t number, CompareSubject subject, const relief::MethodChoice& choice) {
    return std::string(1, static_cast<char>('A' + number)) + " " + relief::variationText(subject, choice);
}

bool ComparedView::isReference(const ComparedPicture& picture) const {
    return picture.shows == against;
}

bool ComparedView::current(const relief::Scenario& requested, std::size_t number) const {
    const std::vector<relief::MethodChoice> all = relief::comparedOf(requested);
    return number < pictures.size() && number < all.size() && pictures[number].shows == shownBy(requested, all[number]);
}

bool ComparedView::measured(const relief::Scenario& requested, std::size_t number) const {
    return complete && !coarse && current(requested, number) &&
           against == shownBy(requested, comparedReference(requested));
}

bool ComparedView::of(const Snapshot& snapshot) const {
    const relief::Scenario& requested = snapshot.scenario;
    const std::size_t count = relief::comparedOf(requested).size();
    bool all = complete && frame == snapshot.frame && count == pictures.size() &&
               against == shownBy(requested, comparedReference(requested));
    for (std::size_t n = 0; n < count && all; ++n) all = current(requested, n);
    return all;
}

Comparer::Rendered& Comparer::rendered(const Snapshot& snapshot, const relief::MethodChoice& choice,
                                       relief::Work& work) {
    const CompareSubject subject = snapshot.scenario.comparison.subject;
    const std::string key = std::string(relief::compareSubjectName(subject)) + "/" +
                            relief::variationText(subject, choice) + (snapshot.coarse ? "/coarse" : "");
    Rendered& at = rendered_[key];
    at.used = calls_;
    if (!at.renderer) at.renderer = std::make_unique<relief::FrameRenderer>(snapshot.maps);
    relief::Assets assets = snapshot.assets;
    if (subject == CompareSubject::Heights) {
        const auto& read = snapshot.request->field.sharedHeights();  // throws if they are read by tiles
        if (at.read != read) at.heights = relief::variedHeights(read, choice);
        at.read = read;
        assets.heights = at.heights;
    }
    relief::FrameRequest request = relief::frameRequest(relief::varied(snapshot.scenario, subject, choice), assets);
    if (snapshot.coarse) {
        request.width = snapshot.request->width;
        request.height = snapshot.request->height;
        request.filter = snapshot.request->filter;
    }
    const std::shared_ptr<const relief::Frame> frame = at.renderer->render(request, work);
    if (frame != at.frame || at.picture.isNull()) {
        at.frame = frame;
        at.picture = makeLayer(Layer::Color, *frame, request, *snapshot.maps, work).image;
    }
    return at;
}

// Renders all pictures except A, which is the snapshot's.
void Comparer::fill(ComparedPicture& picture, const Snapshot& snapshot, relief::Work& work) {
    const relief::HeightField& field = snapshot.request->field;
    const bool method = snapshot.scenario.comparison.subject == CompareSubject::Methods;
    if (method && picture.traces && !relief::supports(picture.choice, field.surface(), field.address())) {
        picture.problem = plainText(CompareText::tr("does not support this surface").toStdString());
        return;
    }
    try {
        const Rendered& made = rendered(snapshot, picture.choice, work);
        picture.frame = made.frame;
        picture.picture = made.picture;
        picture.tracer = made.renderer->tracer();
    } catch (const relief::InputError& error) {
        picture.problem = error.message();
    }
}

std::shared_ptr<const ComparedView> Comparer::view(const Snapshot& snapshot, const ComparedView* before,
                                                   const Listener& made, relief::Work& work) {
    ++calls_;
    auto view = makeFreedInBackground<ComparedView>();
    const relief::Scenario& scenario = snapshot.scenario;
    const CompareSubject subject = scenario.comparison.subject;
    view->scenario = scenario;
    view->coarse = snapshot.coarse;
    view->frame = snapshot.frame;
    view->reference = comparedReferenceName(scenario);
    view->against = shownBy(scenario, comparedReference(scenario));
    const std::vector<relief::MethodChoice> all = relief::comparedOf(scenario);
    if (before) view->pictures = before->pictures;
    view->pictures.resize(all.size());
    for (std::size_t n = 0; n < all.size(); ++n) {
        ComparedPicture picture;
        picture.choice = all[n];
        picture.name = comparedName(n, subject, all[n]);
        picture.traces = rates(subject, all[n]);
        picture.shows = shownBy(scenario, all[n]);
        if (n == 0) {
            picture.frame = snapshot.frame;
            picture.picture = snapshot.picture;
            picture.tracer = snapshot.tracer;
        } else {
            fill(picture, snapshot, work);
        }
        view->pictures[n] = std::move(picture);
        if (made && !view->coarse) made(makeFreedInBackground<ComparedView>(*view));
    }
    if (!snapshot.coarse) {
        const relief::MethodChoice reference = comparedReference(scenario);
        const bool own = relief::sameVariation(subject, reference, all.front());
        measure(*view, own ? *snapshot.frame : *rendered(snapshot, reference, work).frame, work);
    }
    view->rated = std::none_of(view->pictures.begin(), view->pictures.end(),
                               [](const ComparedPicture& picture) { return picture.traces && !picture.problem; });
    view->complete = true;
    // Renderers not used in the last calls are dropped.
    constexpr int kKept = 4;
    std::erase_if(rendered_, [&](const auto& entry) { return entry.second.used + kKept < calls_; });
    return view;
}

}  // namespace reliefui
