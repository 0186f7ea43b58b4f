// The candidates of the advice, and statistics of the relief.
#include <algorithm>
#include <cmath>

#include "measuring/advise/recommend.h"
#include "relief/height_source.h"
#include "relief/tracers/map_choice.h"
#include "relief/tracers/tile_methods.h"

namespace relief {

namespace {

// Returns the values of an option to measure in addition to its default; the same option has the same values for all
// methods.
std::vector<std::string> valuesToMeasure(const MethodDescription& method, const OptionDescription& option,
                                         bool buildsMaps, double lowest, std::int64_t maxSteps) {
    const std::string& name = option.name;
    const bool promises = method.guarantee != Guarantee::Approximate;
    if (option.kind == OptionKind::Method) {
        // Only inner methods with a guarantee, which the outer method then has, too.
        std::vector<std::string> names;
        for (const std::string& inner : option.choices) {
            if (findTracer(inner).guarantee != Guarantee::Approximate) names.push_back(inner);
        }
        return names;
    }
    if (name == "base") return {"1", "2"};
    if (name == "level") return {"2", "4"};
    const auto allowed = [&](std::vector<std::string> values, std::int64_t others) {
        if (maxSteps > others) values.push_back(numberText(static_cast<double>(maxSteps - others)));
        return values;
    };
    if (name == "layers" && !buildsMaps) {
        // A ray takes more steps than layers: the start, the top layer, and the refinement of the last interval.
        const auto halvings = method.defaults.find("bisections");
        const double refining = halvings == method.defaults.end() ? 1 : parseNumber(halvings->second, name);
        return allowed({"32", "128", "256", "512"}, 3 + static_cast<std::int64_t>(refining));
    }
    if (name == "iterations") return allowed({"128"}, 3);
    if (name == kLayoutOption) return {std::string(kStoredLayout)};
    if (name == "sectors") return {"4", "8"};
    if (name == "footprint") return {"4"};
    if (name == "rule") return option.choices;
    // For methods without a guarantee a lower precision saves only memory.
    if (name == "precision" && promises) return option.choices;
    if (name == "flattest" && promises && lowest < parseNumber(method.defaults.at(name), name)) {
        return {numberText(std::clamp(std::floor(lowest * 2) / 2, option.low, option.high))};
    }
    return {};
}

void addForms(const MeasuredMethod& method, double lowest, std::int64_t maxSteps, std::vector<MethodChoice>& forms) {
    const MethodDescription& description = findTracer(method.choice.name);
    std::vector<OptionValues> all{{}};
    for (const OptionDescription& option : description.options) {
        const std::size_t before = all.size();
        for (const std::string& value : valuesToMeasure(description, option, method.buildsMaps, lowest, maxSteps)) {
            if (value == description.defaults.at(option.name)) continue;
            if (std::any_of(all.begin(), all.end(), [&](const OptionValues& known) {
                    return known.contains(option.name) && known.at(option.name) == value && known.size() == 1;
                })) {
                continue;
            }
            // Building takes time for each map, so only one option is varied at a time; the option `rule` needs no map
            // of its own.
            const bool each = !method.buildsMaps || option.name == "rule";
            for (std::size_t v = 0; v < (each ? before : 1); ++v) {
                if (method.buildsMaps && all[v].contains("precision")) continue;
                all.push_back(all[v]);
                all.back()[option.name] = value;
            }
        }
    }
    for (OptionValues& values : all) forms.push_back({method.choice.name, std::move(values)});
}

// Returns n: the statistics are taken from every n-th tile of ReliefFigures on both axes. 1 for a map in memory; for
// one that is read by tiles such that about kSampledTiles are read.
constexpr double kSampledTiles = 1 << 14;
int tileStride(const HeightField& field) {
    constexpr double kTile = ReliefFigures::kTile;
    if (field.tiles() == nullptr) return 1;
    return std::max(1,
                    static_cast<int>(std::sqrt(static_cast<double>(field.texels()) / (kTile * kTile * kSampledTiles))));
}

}  // namespace

std::vector<MethodChoice> adviceForms(const HeightField& field, double lowest, std::int64_t maxSteps, Form form) {
    std::vector<MethodChoice> forms;
    for (const MeasuredMethod& method : defaultMethods()) addForms(method, lowest, maxSteps, forms);
    std::erase_if(forms, [&](const MethodChoice& choice) {
        return !isAccepted(choice) || !supports(choice, field.surface(), field.address()) ||
               (field.tiles() != nullptr && !tracesTiles(choice));
    });
    if (form == Form::Scalar) {
        // A shader reads maps that `relief map` writes, which have the layout of texels.
        std::vector<MethodChoice> stored;
        for (const MethodChoice& choice : forms) {
            const MethodChoice one = withStoredMap(choice);
            if (std::find(stored.begin(), stored.end(), one) == stored.end()) stored.push_back(one);
        }
        forms = std::move(stored);
    }
    // Order of measurement, so that time that runs out costs least: methods with a guarantee first, those without maps
    // before the others. Forms without maps are measured even if time has run out.
    std::stable_sort(forms.begin(), forms.end(), [](const MethodChoice& a, const MethodChoice& b) {
        const auto rank = [](const MethodChoice& form) {
            const bool guaranteed = findTracer(form.name).guarantee != Guarantee::Approximate;
            if (!measuredMethod(form).buildsMaps) return guaranteed ? 0 : 3;
            if (form.options.contains("inner")) return 2;
            return guaranteed ? 1 : 4;
        };
        return rank(a) < rank(b);
    });
    return forms;
}

namespace {

template <class Heights>
ReliefFigures figuresOf(const Heights& heights, const HeightField& field) {
    const double texels = field.slabTexels();
    const int width = field.width(), height = field.height();
    ReliefFigures figures;
    std::int64_t pairs = 0, steep = 0, tiles = 0, flat = 0;
    double sum = 0;
    float lowest = heights(0, 0), highest = lowest;
    const auto pair = [&](float a, float b) {
        const double slope = std::abs(static_cast<double>(a) - static_cast<double>(b)) * texels;
        ++pairs;
        sum += slope;
        if (slope > 1) ++steep;
    };
    const int every = ReliefFigures::kTile * tileStride(field);
    for (int y0 = 0; y0 < height; y0 += every) {
        for (int x0 = 0; x0 < width; x0 += every) {
            float low = heights(x0, y0), high = low;
            for (int y = y0; y < std::min(y0 + ReliefFigures::kTile, height); ++y) {
                for (int x = x0; x < std::min(x0 + ReliefFigures::kTile, width); ++x) {
                    const float here = heights(x, y);
                    low = std::min(low, here);
                    high = std::max(high, here);
                    if (x + 1 < width) pair(here, heights(x + 1, y));
                    if (y + 1 < height) pair(here, heights(x, y + 1));
                }
            }
            constexpr double kFlat = 0.5;  // texels
            ++tiles;
            if (static_cast<double>(high - low) * texels < kFlat) ++flat;
            lowest = std::min(lowest, low);
            highest = std::max(highest, high);
        }
    }
    figures.flat = lowest == highest;
    if (pairs > 0) {
        figures.roughness = sum / static_cast<double>(pairs);
        figures.steep = static_cast<double>(steep) / static_cast<double>(pairs);
    }
    figures.flatTiles = static_cast<double>(flat) / static_cast<double>(tiles);
    return figures;
}

}  // namespace

ReliefFigures reliefFigures(const HeightField& field) {
    ReliefFigures figures = withHeights(field, [&](const auto& heights) { return figuresOf(heights, field); });
    if (const TiledHeights* const tiles = field.tiles()) {
        const int top = tiles->levels() - 1;
        figures.flat = tiles->minimum(top, 0, 0) == tiles->maximum(top, 0, 0);
    }
    return figures;
}

std::string_view verdictName(Verdict verdict) {
    switch (verdict) {
        case Verdict::Kept:
            return "kept";
        case Verdict::Error:
            return "error";
        case Verdict::Steps:
            return "steps";
        case Verdict::Memory:
            return "memory";
        case Verdict::BuildTime:
            return "build-time";
        case Verdict::Refused:
            return "refused";
        case Verdict::Slow:
            return "slow";
        case Verdict::Fetches:
            return "fetches";
    }
    return "";
}

std::vector<Elevation> parseViews(const std::string& text, const std::string& option) {
    if (text == "random") return {std::nullopt};
    const InputError fault(option, Message(MessageId::NotAViewRange, {{"text", text}, {"low", kLowestElevation}}));
    const std::size_t comma = text.find(',');
    double low = 0;
    double high = 0;
    try {
        low = parseElevation(text.substr(0, comma), option).value_or(-1);
        high = comma == std::string::npos ? low : parseElevation(text.substr(comma + 1), option).value_or(-1);
    } catch (const InputError&) {
        throw fault;
    }
    if (low < 0 || high < low) throw fault;
    if (low == high) return {low};
    std::vector<Elevation> views;
    for (int v = 0; v < kAdviceViews; ++v) views.push_back(low + (high - low) * v / (kAdviceViews - 1));
    return views;
}

std::string viewsText(const std::vector<Elevation>& views) {
    if (!views.front()) return "random";
    std::string text = numberText(*views.front(), 4);
    if (views.size() > 1) text += "," + numberText(*views.back(), 4);
    return text;
}

}  // namespace relief
