#include "relief/visibility/any_hit.h"

#include <tuple>

#include "base/for_each_type.h"
#include "relief/block_work.h"
#include "relief/visibility/max_pyramid_any.h"
#include "relief/visibility/packed_cone_any.h"

namespace relief {

namespace {

// The explicit list: one line a query.
using QueryTypes = std::tuple<MaxPyramidAnyHit, PackedConeAnyHit>;

template <class T>
class QueryOf final : public AnyHitQuery {
    static_assert(T::kRays == RayClass::AnyRays, "shadows and back-tracing need a map that is valid for any ray");

  public:
    explicit QueryOf(T query) : query_(std::move(query)) {}

    const MethodDescription& description() const override { return descriptionOf<T>(); }
    const HeightField& field() const override { return query_.field(); }
    double stepBound(const AnyRay& ray) const override { return query_.stepBound(ray); }

    void look(const AnyRayBlock& rays, SightBlock& sights, NullSink&, Work& work) const override {
        sights.resize(rays.size());
        overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
            if constexpr (requires { query_.lookLanes(rays, first, last, sights); }) {
                query_.lookLanes(rays, first, last, sights);
            } else {
                NullSink sink;
                for (std::size_t i = first; i < last; ++i) sights.sight[i] = query_.look(rays[i], sink);
            }
        });
    }

    void look(const AnyRayBlock& rays, SightBlock& sights, BlockCounts& counts, Work& work) const override {
        sights.resize(rays.size());
        countBlock(rays.size(), sights, counts, work,
                   [&](std::size_t i, CountSink& sink) { sights.sight[i] = query_.look(rays[i], sink); });
    }

    void look(const AnyRayBlock& rays, SightBlock& sights, StepLog& log, Work& work) const override {
        sights.resize(rays.size());
        logBlock(rays.size(), sights, log, work,
                 [&](std::size_t i, LogSink& sink) { sights.sight[i] = query_.look(rays[i], sink); });
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

MethodChoice sightChoice(const HeightField& field) {
    const bool packed = field.heights().size() <= kPackedSight;
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
