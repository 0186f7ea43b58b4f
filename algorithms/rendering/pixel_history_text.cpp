#include "rendering/pixel_history_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace relief {

namespace {

constexpr int kDigits = 4;
constexpr std::size_t kMostTexels = 12;
constexpr std::size_t kMostRays = 64;

std::string number(double value) {
    return numberText(value, kDigits);
}

std::string sum(double a, double b) {
    return number(a) + (b < 0 ? " − " : " + ") + number(std::abs(b));
}

// Returns one number where all channels are equal.
std::string channels(const glm::dvec3& v) {
    if (v.x == v.y && v.y == v.z) return number(v.x);
    return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

std::string color(const glm::dvec3& v) {
    return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

class Stations {
  public:
    Stations(const PixelHistory& history, const FrameRequest& request) : history_(history), request_(request) {}

    std::vector<HistoryStation> take() {
        const auto code = [&](std::size_t channel) { return std::to_string(history_.srgb[channel]); };
        station(Message(MessageId::HistoryPixel, {{"x", history_.x}, {"y", history_.y}}));
        equation("c", color(glm::dvec3(history_.drawn)), "");
        equation("sRGB", "(" + code(0) + ", " + code(1) + ", " + code(2) + ")", "");
        if (history_.rays.size() == 1) {
            one(history_.rays.front());
        } else {
            several();
        }
        product();
        return std::move(stations_);
    }

  private:
    void station(Message title) { stations_.push_back({std::move(title), {}, {}}); }
    void note(Message message) { stations_.back().notes.push_back(std::move(message)); }
    void equation(std::string formula, std::string result, std::string numbers) {
        stations_.back().equations.push_back({std::move(formula), std::move(numbers), std::move(result)});
    }

    void one(const HistoryRay& ray) {
        coverage(ray);
        if (!ray.polygon) return;
        hit(ray);
        if (ray.hit.outcome != Outcome::Hit) return;
        filter(ray);
        light(ray);
    }

    void coverage(const HistoryRay& ray) {
        station(Message(MessageId::HistoryCoverage));
        if (!ray.polygon) return note(Message(MessageId::HistorySky));
        note(Message(MessageId::HistoryPolygon, {{"polygon", *ray.polygon}, {"depth", number(ray.entryDepth)}}));
        equation("(s_0, t_0)", "(" + number(ray.ray.s0) + ", " + number(ray.ray.t0) + ")", "");
        equation("(a, b)", "(" + number(ray.ray.a) + ", " + number(ray.ray.b) + ")", "");
    }

    void hit(const HistoryRay& ray) {
        station(Message(MessageId::HistoryHit, {{"method", history_.method}}));
        if (ray.hit.outcome == Outcome::Limit) return note(Message(MessageId::HistoryLimit));
        if (ray.hit.outcome != Outcome::Hit) return note(Message(MessageId::HistoryMiss));
        if (ray.by == HitBy::FlatGround) note(Message(MessageId::HistoryFlat));
        if (ray.by == HitBy::LittleParallax) note(Message(MessageId::HistoryParallax));
        const double lambda = ray.hit.lambda;
        equation("λ", number(lambda), "");
        equation("s = s_0 + λ a", number(ray.hit.s), sum(ray.ray.s0, lambda * ray.ray.a));
        equation("t = t_0 + λ b", number(ray.hit.t), sum(ray.ray.t0, lambda * ray.ray.b));
        equation("z = 1 − λ", number(1 - lambda), "");
    }

    void filter(const HistoryRay& ray) {
        if (ray.height) {
            station(Message(MessageId::HistoryGrey));
            equation("f = 0.2 + 0.6 h", color(ray.sum), "0.2 + 0.6 · " + number(*ray.height));
            return;
        }
        station(Message(MessageId::HistoryFilter, {{"filter", request_.filter.name}, {"texels", ray.texels.size()}}));
        if (ray.hidden > 0) note(Message(MessageId::HistoryHidden, {{"texels", ray.hidden}}));
        if (ray.allHidden) note(Message(MessageId::HistoryAllHidden));
        // The heaviest texels, and the sum of the others.
        std::vector<std::size_t> order(ray.texels.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto weight = [&](std::size_t n) {
            const glm::dvec3& w = ray.texels[n].weight;
            return w.x + w.y + w.z;
        };
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
        const std::size_t shown = order.size() > kMostTexels ? kMostTexels - 1 : order.size();
        glm::dvec3 rest(0);
        for (std::size_t n = 0; n < order.size(); ++n) {
            const HistoryTexel& texel = ray.texels[order[n]];
            const glm::dvec3 product = texel.weight * glm::dvec3(texel.color);
            if (n >= shown) {
                rest += product;
                continue;
            }
            const std::string name = "w c_{" + std::to_string(texel.i) + "," + std::to_string(texel.j) +
                                     (texel.level > 0 ? ",l" + std::to_string(texel.level) : "") + "}";
            equation(name, color(product), channels(texel.weight) + " · " + color(glm::dvec3(texel.color)));
        }
        if (shown < order.size()) {
            note(Message(MessageId::HistoryRest, {{"texels", order.size() - shown}}));
            equation("Σ", color(rest), "");
        }
        equation("f = Σ w c", color(ray.sum), "");
    }

    void light(const HistoryRay& ray) {
        station(Message(MessageId::HistoryLight));
        const Light& light = request_.light;
        const glm::dvec3 toLight = lightDirection(light);
        if (ray.shadowed) {
            note(Message(MessageId::HistoryShadow));
        } else if (ray.cosine <= 0) {
            note(Message(MessageId::HistoryAway));
        }
        equation("n · l", number(ray.cosine), color(ray.normal) + " · " + color(toLight));
        const bool dark = ray.shadowed || ray.cosine <= 0;
        const std::string part = number(light.intensity) + " (" + number(light.ambient);
        if (dark) {
            equation("L = I a", number(ray.amount), number(light.intensity) + " · " + number(light.ambient));
        } else {
            equation("L = I (a + (1 − a) n · l)", number(ray.amount),
                     part + " + " + number(1 - light.ambient) + " · " + number(ray.cosine) + ")");
        }
    }

    static MessageId outcome(const HistoryRay& ray) {
        if (!ray.polygon) return MessageId::HistoryRaySky;
        if (ray.hit.outcome == Outcome::Limit) return MessageId::HistoryRayLimit;
        return ray.hit.outcome == Outcome::Hit ? MessageId::HistoryRayHit : MessageId::HistoryRayMiss;
    }

    void several() {
        station(Message(MessageId::HistoryRays, {{"rays", history_.rays.size()}, {"method", history_.method}}));
        std::array<std::size_t, 4> counts{};
        const std::array ids{MessageId::HistoryRayHit, MessageId::HistoryRaySky, MessageId::HistoryRayMiss,
                             MessageId::HistoryRayLimit};
        for (const HistoryRay& ray : history_.rays) {
            ++counts[static_cast<std::size_t>(std::find(ids.begin(), ids.end(), outcome(ray)) - ids.begin())];
        }
        for (std::size_t n = 0; n < ids.size(); ++n) {
            if (counts[n] > 0) note(Message(ids[n], {{"rays", counts[n]}}));
        }
        glm::dvec3 rest(0);
        for (std::size_t n = 0; n < history_.rays.size(); ++n) {
            const HistoryRay& ray = history_.rays[n];
            if (n >= kMostRays) {
                rest += ray.share * ray.product;
                continue;
            }
            const bool hit = ray.polygon && ray.hit.outcome == Outcome::Hit;
            std::string numbers = channels(ray.share) + " · " + color(hit ? ray.sum : ray.product);
            if (hit) numbers += " · " + number(ray.amount);
            equation((hit ? "w f L_{" : "w c_{") + std::to_string(n + 1) + "}", color(ray.share * ray.product),
                     std::move(numbers));
        }
        if (history_.rays.size() > kMostRays) {
            note(Message(MessageId::HistoryRest, {{"texels", history_.rays.size() - kMostRays}}));
            equation("Σ", color(rest), "");
        }
    }

    void product() {
        station(Message(MessageId::HistoryProduct));
        const bool single = history_.rays.size() == 1;
        const HistoryRay& first = history_.rays.front();
        const bool hit = first.polygon && first.hit.outcome == Outcome::Hit;
        if (!single) {
            equation("Σ", color(history_.product), "");
        } else if (hit) {
            equation("f L", color(history_.product), color(first.sum) + " · " + number(first.amount));
        } else {
            equation("c", color(history_.product), "");
        }
        note(Message(history_.multipliesOut() ? MessageId::HistoryAgrees : MessageId::HistoryDiffers,
                     {{"difference", numberText(history_.difference(), 2)}, {"bound", numberText(history_.bound, 2)}}));
    }

    const PixelHistory& history_;
    const FrameRequest& request_;
    std::vector<HistoryStation> stations_;
};

}  // namespace

std::vector<HistoryStation> historyStations(const PixelHistory& history, const FrameRequest& request) {
    return Stations(history, request).take();
}

std::string historyText(const PixelHistory& history, const FrameRequest& request, Language language) {
    std::string text;
    for (const HistoryStation& station : historyStations(history, request)) {
        text += sentence(station.title, language) + "\n";
        for (const Message& message : station.notes) text += "  " + sentence(message, language) + "\n";
        for (const HistoryEquation& row : station.equations) {
            text += "  " + row.formula + " = " + (row.numbers.empty() ? "" : row.numbers + " = ") + row.result + "\n";
        }
    }
    return text;
}

}  // namespace relief
