#include "relief/visibility/any_hit.h"

#include <tuple>

#include "base/for_each_type.h"
#include "relief/block_work.h"
#include "relief/visibility/max_pyramid_any.h"
#include "relief/visibility/packed_cone_any.h"

namespace relief {

namespace {

// The explicit list of queries, one per line.
using QueryTypes = std::tuple<MaxPyramidAnyHit, PackedConeAnyHit>;

template <class T>
class QueryOf final : public AnyHitQuery {
    static_assert(T::kRays == RayClass::AnyRays, "shadows and back-tracing need a map that is valid for any ray");

  public:
    explicit QueryOf(T query) : query_(std::move(query)) {}

    const MethodDescription& description() const override { return descriptionOf<T>(); }
    const HeightField& field() const override { return query_.field(); }
    double stepBound(const AnyRay& ray) const override { return query_.stepBound(ray); }

    void query(const AnyRayBlock& rays, VisibilityBlock& results, NullSink&, Work& work) const override {
        results.resize(rays.size());
        overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
            if constexpr (requires { query_.querySimd(rays, first, last, results); }) {
                query_.querySimd(rays, first, last, results);
            } else {
                NullSink sink;
                for (std::size_t i = first; i < last; ++i) results.visibility[i] = query_.query(rays[i], sink);
            }
        });
    }

    void query(const AnyRayBlock& rays, VisibilityBlock& results, BlockCounts& counts, Work& work) const override {
        results.resize(rays.size());
        countBlock(rays.size(), results, counts, work,
                   [&](std::size_t i, CountSink& sink) { results.visibility[i] = query_.query(rays[i], sink); });
    }

    void query(const AnyRayBlock& rays, VisibilityBlock& results, StepLog& log, Work& work) const override {
        results.resize(rays.size());
        logBlock(rays.size(), results, log, work,
                 [&](std::size_t i, LogSink& sink) { results.visibility[i] = query_.query(rays[i], sink); });
    }

  private:
    T query_;
};

}  // namespace

const std::vector<MethodDescription>& anyHitList() {
    static const std::vector<MethodDescription> list = [] {
        std::vector<MethodDescription> all;
        forEachType<QueryTypes>([&]<class T>() { all.push_back(descriptionOf<T>()); });
        return all;
    }();
    return list;
}

MethodChoice visibilityChoice(const HeightField& field) {
    const bool packed = field.tiles() == nullptr && field.texels() <= kMaxPackedTexels;
    return {packed ? descriptionOf<PackedConeAnyHit>().name : descriptionOf<MaxPyramidAnyHit>().name, {}};
}

std::unique_ptr<AnyHitQuery> makeAnyHit(const MethodChoice& choice, const HeightField& field, MapCache& cache,
                                        Work& work) {
    std::unique_ptr<AnyHitQuery> made;
    forEachType<QueryTypes>([&]<class T>() {
        if (descriptionOf<T>().name != choice.name) return;
        const auto options = parseOptions<typename T::Options>(choice.name, choice.options);
        made = std::make_unique<QueryOf<T>>(T::make(field, options, cache, work));
    });
    if (!made) {
        throw InputError("any-hit query",
                         unknownName({"what", MessageId::WordAnyHit}, choice.name, namesOf(anyHitList())));
    }
    return made;
}

}  // namespace relief
