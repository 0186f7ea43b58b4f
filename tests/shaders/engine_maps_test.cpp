// The maps that `relief map` writes for engines, as the exported shaders read them: in codes of 8 or 16 bits, rounded
// outward, with the conventions that both state.
#include <map>
#include <set>

#include "algorithms/relief/fields.h"
#include "measuring/advise/shader_forms.h"
#include "relief/maps/engine_builders.h"
#include "shaders/shader_fixture.h"

namespace relief::test {
namespace {

class ShaderEngineMaps : public ShaderTest {
  protected:
    static EngineConventions conventions(const std::string& pack, int bits, ConeUnit unit) {
        EngineConventions all;
        all.channels = parseEnginePack(pack, "--pack");
        all.bits = bits;
        all.cone.unit = unit;
        return all;
    }
    static ShaderTexture texture(const EngineLevel& level, bool linear) {
        const FloatImage& first = level.channels[0];
        ShaderTexture data{first.width(), first.height(), 1, static_cast<int>(level.channels.size()), {{}}, linear};
        for (int y = 0; y < data.height; ++y) {
            for (int x = 0; x < data.width; ++x) {
                for (const FloatImage& channel : level.channels) data.levels[0].push_back(channel(x, y));
            }
        }
        return data;
    }
    static ShaderChoice shader(const std::string& tracer, const EngineConventions& c) {
        ShaderChoice choice;
        choice.method.name = tracer;
        choice.cones = c.cone;
        return choice;
    }
    // Traces rays by the shader and by `exact` over the heights that the map holds. Returns how far the shader's hits
    // lie behind the exact ones at most, and before them on average, texels.
    struct Found {
        double behind = 0, before = 0;
    };
    Found trace(const ShaderChoice& choice, const HeightField& field) {
        const auto [numbers, rounded] = shaderRays(randomRays(7, field, 1000, 10));
        const std::vector<float> answers = gl_->compute(rayPassText(shaderText(choice, "test")), numbers);
        HitBlock hits;
        NullSink sink;
        MapCache maps;
        makeTracer({"exact", {}}, field, maps, work_)->trace(rounded, hits, sink, work_);
        Found found;
        for (std::size_t i = 0; i < rounded.size(); ++i) {
            EXPECT_GT(answers[4 * i], 0) << "under repeat every ray hits";
            const double off = (static_cast<double>(answers[4 * i + 1]) - hits.lambda[i]) * texelsOf(rounded[i]);
            found.behind = std::max(found.behind, off);
            found.before += std::max(-off, 0.0) / static_cast<double>(rounded.size());
        }
        return found;
    }

    const HeightField field_{share(makeRelief("bricks", 60, 45, 1)), Surface::Bilinear, Address::Repeat, 0.1};
};

TEST_F(ShaderEngineMaps, ConesOnTheSurfaceNeverLeadThroughIt) {
    for (const ConeUnit unit : {ConeUnit::Ratio, ConeUnit::SqrtRatio, ConeUnit::Slope}) {
        const EngineMap map =
            buildEngineCones(ConeKind::Conservative, {}, field_, conventions("R=height,G=cone", 8, unit), 1, work_);
        const HeightField rounded(share(*map.heights()), Surface::Bilinear, Address::Repeat, 0.1);
        ShaderChoice choice = shader("cone-robust", map.conventions);
        choice.method.options["iterations"] = "1024";
        bindMaps(*gl_, choice, rounded, {}, work_);
        gl_->setTexture(1, texture(map.levels[0], true), Address::Repeat);
        const Found found = trace(choice, rounded);
        EXPECT_LE(found.behind, kSameAnswer) << coneUnitName(unit);
        EXPECT_LE(found.before, 0.5) << coneUnitName(unit) << ": the steps come near the surface";
    }
}

TEST_F(ShaderEngineMaps, ConesOfCellsFindTheExactHit) {
    const EngineMap map = buildEngineCones(ConeKind::Conservative, {}, field_,
                                           conventions("R=apex,G=cone", 16, ConeUnit::SqrtRatio), 1, work_);
    const ShaderChoice choice = shader("cone", map.conventions);
    bindMaps(*gl_, choice, field_, {}, work_);
    gl_->setTexture(3, texture(map.levels[0], false), Address::Repeat);
    const Found found = trace(choice, field_);
    EXPECT_LE(found.behind, kSameAnswer);
    EXPECT_LE(found.before, kSameAnswer);
}

TEST_F(ShaderEngineMaps, LevelsOfMaximaFindTheExactHit) {
    const EngineMap map =
        buildEnginePyramid(PyramidKind::Max, field_, conventions("R=height", 16, ConeUnit::Ratio), work_);
    const HeightField rounded(share(*map.heights()), Surface::Bilinear, Address::Repeat, 0.1);
    const ShaderChoice choice = shader("max-pyramid", map.conventions);
    bindMaps(*gl_, choice, rounded, {}, work_);
    std::vector<FloatImage> levels;
    for (const EngineLevel& level : map.levels) levels.push_back(level.channels[0]);
    gl_->setTexture(3, levelsTexture(levels), Address::Repeat);
    const Found found = trace(choice, rounded);
    EXPECT_LE(found.behind, kSameAnswer);
    EXPECT_LE(found.before, kSameAnswer);
}

// The shader that `relief recommend --form shader` advises, over the textures that it advises, hits where the method
// hits that was measured, in no more steps than the limit.
TEST_F(ShaderEngineMaps, AdvisedShadersHitWhereWasMeasured) {
    ShaderAdviceOptions options(field_);
    options.maxSteps = 24;
    std::set<std::pair<ShaderMap, int>> tried;
    for (const int bits : {8, 16}) {
        for (const ShaderForm& form : shaderForms(options, bits)) {
            const std::map<ShaderMap, ConeKind> kinds{{ShaderMap::SurfaceCones, ConeKind::Robust},
                                                      {ShaderMap::RelaxedCones, ConeKind::Relaxed},
                                                      {ShaderMap::RobustRelaxedCones, ConeKind::RelaxedRobust}};
            if (!kinds.contains(form.map)) continue;
            if (!tried.emplace(form.map, bits).second) continue;  // the largest number of steps comes first
            EngineConventions c = conventions("R=height,G=cone", bits, ConeUnit::Slope);
            c.cone.length = ConeLength::Width;
            const EngineMap map = buildEngineCones(kinds.at(form.map), {}, field_, c, 1, work_);
            const ShaderStore store = shaderStore(form, field_, work_);
            const ShaderChoice choice = shaderChoiceOf(form, Address::Repeat, store.coneScale);
            bindMaps(*gl_, choice, store.field, {}, work_);
            gl_->setTexture(1, texture(map.levels[0], true), Address::Repeat);
            const auto [numbers, rounded] = shaderRays(randomRays(7, field_, 1000, 10));
            const std::vector<float> answers = gl_->compute(rayPassText(shaderText(choice, "test")), numbers);
            HitBlock hits;
            NullSink sink;
            makeTracer(form.method, store.field, *store.maps, work_)->trace(rounded, hits, sink, work_);
            std::size_t other = 0;
            for (std::size_t i = 0; i < rounded.size(); ++i) {
                EXPECT_LE(answers[4 * i + 2], options.maxSteps) << methodText(form.method);
                const double off = std::abs(static_cast<double>(answers[4 * i + 1]) - hits.lambda[i]);
                other += off * texelsOf(rounded[i]) > kSameAnswer ? 1 : 0;
            }
            // A graphics card's sampler moves hits: an H100 up to 8.5% of them by more than kSameAnswer.
            EXPECT_LE(other, rounded.size() / (samplesInFloat() ? 100 : 8)) << methodText(form.method) << " " << bits;
        }
    }
    EXPECT_EQ(tried.size(), 6U);
}

}  // namespace
}  // namespace relief::test
