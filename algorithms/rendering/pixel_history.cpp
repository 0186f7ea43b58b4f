#include "rendering/pixel_history.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "filtering/color_levels.h"
#include "relief/methods/look_up_point.h"
#include "rendering/display.h"
#include "rendering/point_texels.h"
#include "rendering/supersample.h"

namespace relief {

namespace {

// The picture that a filter samples, with its levels, made when they are first needed.
class Texture {
  public:
    Texture(const FrameRequest& request, Work& work) : request_(request), work_(work) {}

    const ColorImage& level(int l) {
        if (l == 0) return picture();
        if (!levels_) {
            picture();
            levels_.emplace(picture_, work_);
        }
        return levels_->level(std::min(l, levels_->top()));
    }
    SampledTexture size() { return {picture().width(), picture().height(), request_.field.address()}; }

  private:
    // Without a colour picture, the heights in grey.
    const ColorImage& picture() {
        if (picture_) return *picture_;
        picture_ = request_.color;
        if (picture_) return *picture_;
        const FloatImage& heights = *request_.field.sharedHeights();
        auto grey = std::make_shared<ColorImage>(heights.width(), heights.height());
        std::transform(heights.pixels().begin(), heights.pixels().end(), grey->pixels().begin(),
                       [](float height) { return heightGrey(height); });
        picture_ = std::move(grey);
        return *picture_;
    }

    const FrameRequest& request_;
    Work& work_;
    std::shared_ptr<const ColorImage> picture_;
    std::optional<ColorLevels> levels_;
};

// Explains one ray of a frame that has all stages of its row.
class RayExplainer {
  public:
    RayExplainer(const Frame& frame, const FrameRequest& request, Texture& texture, Work& work)
        : frame_(frame),
          request_(request),
          texture_(texture),
          work_(work),
          visible_(frame.visible(request)),
          toLight_(lightDirection(request.light)) {}

    HistoryRay explain(int x, int y) {
        HistoryRay out;
        const std::size_t i = frame_.index(x, y);
        out.sample = request_.sample;
        out.pixel = {x - request_.margin, y - request_.margin};
        out.lit = frame_.light->color(x, y - frame_.lit.begin);
        out.product = glm::dvec3(request_.sky);
        if (frame_.rays->polygon[i] == kNoPolygon) return out;
        out.polygon = frame_.rays->polygon[i];
        out.ray = frame_.rays->rays[i];
        out.entryDepth = 1 / static_cast<double>(frame_.rays->inverseDepth[i]);
        out.hit = frame_.hits->hits[i];
        out.by = frame_.hits->by[i];
        if (out.hit.outcome == Outcome::Limit) out.product = glm::dvec3(0);
        if (out.hit.outcome != Outcome::Hit) return out;
        filter(out, x, y);
        light(out, x, y, i);
        out.product = out.sum * out.amount;
        return out;
    }

  private:
    void filter(HistoryRay& out, int x, int y) {
        out.filtered = frame_.color->color.pixels()[frame_.index(x, y)];
        const glm::dvec2 place = lookUpPoint(request_.field, out.ray, out.hit);
        if (!frame_.filter) {
            out.height = request_.field.at(place.x, place.y);
            out.sum = glm::dvec3(heightGrey(*out.height));
            return;
        }
        const auto query = filterQuery(frame_, request_, visible_, x, y);
        const bool plain = frame_.plainFilter && tinyFootprint(*query, frame_, request_);
        const TextureFilter& used = plain ? *frame_.plainFilter : *frame_.filter;
        FootprintCounts counts;
        FootprintLog log;
        log.footprint.kind = FootprintKind::Bilinear;
        used.color(*query, counts, work_, &log);
        out.hidden = counts.hidden;
        out.allHidden = log.allHidden;
        std::vector<FootprintTexel> texels = std::move(log.texels);
        const SampledTexture size = texture_.size();
        const LevelFootprint& footprint = log.footprint;
        const glm::dvec2 perField{static_cast<double>(size.width) / request_.field.width(),
                                  static_cast<double>(size.height) / request_.field.height()};
        if (log.allHidden) {
            // The filter samples the colour at the hit instead.
            addBilinearTexels(texels, size, footprint.centre * std::ldexp(1.0, footprint.level), 0, 0, Color(1));
        } else if (texels.empty() && footprint.kind == FootprintKind::Top) {
            texels.push_back({0, 0, footprint.level, 0, 0, Color(1)});
        } else if (texels.empty()) {
            addPointTexels(texels, request_, size, used.description().name, footprint.level,
                           scaled(query->jacobian, perField), place * perField, Color(1));
        }
        // A filter may sample a texel several times.
        glm::dvec3 total(0);
        std::map<std::tuple<int, int, int>, glm::dvec3> weights;
        for (const FootprintTexel& texel : texels) {
            if (texel.hidden) continue;
            total += glm::dvec3(texel.weight);
            weights.try_emplace({texel.level, texel.j, texel.i}, 0).first->second += glm::dvec3(texel.weight);
        }
        for (const auto& [where, weight] : weights) {
            const auto& [level, j, i] = where;
            const Color color = texture_.level(level)(i, j);
            out.texels.push_back({level, i, j, weight / total, color});
            out.sum += out.texels.back().weight * glm::dvec3(color);
        }
    }

    void light(HistoryRay& out, int x, int y, std::size_t i) const {
        const Light& light = request_.light;
        out.normal = glm::dvec3(frame_.normal(x, y, request_));
        out.cosine = glm::dot(out.normal, toLight_);
        const std::vector<std::uint8_t>& shadowed = frame_.shadows->shadowed;
        out.shadowed = !shadowed.empty() && shadowed[i] != 0;
        const double facing = out.shadowed ? 0 : std::max(0.0, out.cosine);
        out.amount = light.intensity * (light.ambient + (1 - light.ambient) * facing);
    }

    const Frame& frame_;
    const FrameRequest& request_;
    Texture& texture_;
    Work& work_;
    VisiblePolygons visible_;
    glm::dvec3 toLight_;
};

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// The bound grows with the texels and the light.
double boundOf(const std::vector<HistoryRay>& rays) {
    double most = 1;
    for (const HistoryRay& ray : rays) {
        double texel = 1;
        for (const HistoryTexel& one : ray.texels) texel = std::max(texel, largest(glm::dvec3(one.color)));
        most = std::max(most, texel * std::max(1.0, ray.amount));
    }
    return kHistoryBound * most;
}

}  // namespace

double PixelHistory::difference() const {
    return largest(product - glm::dvec3(drawn));
}

PixelHistory pixelHistory(const FrameRequest& request, int x, int y, const std::shared_ptr<MapCache>& maps,
                          Work& work) {
    if (x < 0 || y < 0 || x >= request.width || y >= request.height) {
        throw InputError("--pixel",
                         Message(MessageId::PixelOutside,
                                 {{"x", x}, {"y", y}, {"width", request.width}, {"height", request.height}}));
    }
    PixelHistory out;
    out.x = x;
    out.y = y;
    Texture texture(request, work);
    FrameRenderer renderer(maps);
    const auto draw = [&](const FrameRequest& pass, RowRange rows, const auto& explain) {
        PictureParts parts;
        parts.onlyRows = rows;
        parts.done = [&](const Frame& part) { explain(RayExplainer(part, pass, texture, work), part); };
        return renderer.picture(pass, work, parts);
    };
    if (request.filter.name != kSupersample) {
        const auto frame = draw(request, {y, y + 1}, [&](RayExplainer explainer, const Frame& part) {
            if (y >= part.rows.begin && y < part.rows.end) out.rays.push_back(explainer.explain(x, y));
        });
        out.method = frame->tracedBy;
        out.drawn = frame->light->color(x, y - frame->lit.begin);
    } else {
        for (const SamplePass& pass : samplePasses(request)) {
            const int ring = pass.request.margin - request.margin;
            const auto frame =
                draw(pass.request, {y, y + 1 + 2 * ring}, [&](RayExplainer explainer, const Frame& part) {
                    for (const SampleShare& share : pass.shares) {
                        const int row = y + ring + share.y;
                        if (row < part.rows.begin || row >= part.rows.end) continue;
                        HistoryRay ray = explainer.explain(x + ring + share.x, row);
                        ray.share = share.share;
                        out.rays.push_back(std::move(ray));
                    }
                });
            out.method = frame->tracedBy;
        }
        out.drawn = renderer.picture(request, work, {false, {}, 0, {y, y + 1}})->light->color(x, 0);
    }
    for (const HistoryRay& ray : out.rays) out.product += ray.share * ray.product;
    out.bound = boundOf(out.rays);
    std::uint32_t code = 0;
    toSrgb32({&out.drawn, 1}, {&code, 1});
    out.srgb = {static_cast<std::uint8_t>(code >> 16U), static_cast<std::uint8_t>(code >> 8U),
                static_cast<std::uint8_t>(code)};
    return out;
}

}  // namespace relief
