// Heights of maps that are read by tiles: SIMD version of TiledHeights::corners(). Compiled for each target.

#if defined(RELIEF_TILE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_TILE_LANES_INL_H
#undef RELIEF_TILE_LANES_INL_H
#else
#define RELIEF_TILE_LANES_INL_H
#endif

#include <array>

#include "images/tiled_heights.h"
#include "relief/simd/double_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Heights of the nodes (i0, j0), (i1, j0), (i0, j1), (i1, j1) of cells, or of texels of a level of maxima.
template <class D>
struct FourHeights {
    hn::Vec<D> h00, h10, h01, h11;
};
template <class D>
using TileIndex = hn::Vec<hn::RebindToSigned<D>>;
template <class D>
using TileMask = hn::Mask<hn::RebindToSigned<D>>;

#if HWY_TARGET <= HWY_AVX2
// The 64 bits that hold two neighbouring heights, as two vectors of 32 bits; shorter heights are both in the first.
// group, low, at: number of the group of tiles, byte of the tile in it, byte of the first height in the tile.
template <class DI>
HWY_INLINE void tileWords(DI d, const TileAccess& access, hn::Vec<DI> group, hn::Vec<DI> low, hn::Vec<DI> at,
                          hn::Vec<DI>& first, hn::Vec<DI>& second) {
    if constexpr (hn::MaxLanes(DI()) > kHalfLanes) {
        const hn::Half<DI> half;
        hn::Vec<hn::Half<DI>> left1, left2, right1, right2;
        tileWords(half, access, hn::LowerHalf(half, group), hn::LowerHalf(half, low), hn::LowerHalf(half, at), left1,
                  left2);
        tileWords(half, access, hn::UpperHalf(half, group), hn::UpperHalf(half, low), hn::UpperHalf(half, at), right1,
                  right2);
        first = hn::Combine(d, right1, left1), second = hn::Combine(d, right2, left2);
    } else {
        const hn::Rebind<std::int64_t, DI> wide;
        const hn::Rebind<std::uint32_t, DI> narrow;
        const hn::RebindToUnsigned<decltype(wide)> bits;
        // Not beyond the tile: what is there need not be resident.
        const auto from =
            hn::Min(at, hn::Set(d, (1 << access.tileBytesShift) - static_cast<int>(sizeof(std::int64_t))));
        const auto skipped = hn::BitCast(bits, hn::PromoteTo(wide, hn::ShiftLeft<3>(hn::Sub(at, from))));
        const auto bytes =
            hn::Add(hn::ShiftLeft<kGroupShift>(hn::PromoteTo(wide, group)), hn::PromoteTo(wide, hn::Add(low, from)));
        const auto gathered = hn::GatherOffset(wide, reinterpret_cast<const std::int64_t*>(access.map), bytes);
        const auto words = hn::Shr(hn::BitCast(bits, gathered), skipped);
        first = hn::BitCast(d, hn::TruncateTo(narrow, words));
        second = hn::BitCast(d, hn::TruncateTo(narrow, hn::ShiftRight<32>(words)));
    }
}

// The two neighbouring heights that tileWords() fetched.
template <class D>
HWY_INLINE void decodedPair(D d, NumberType type, TileIndex<D> first, TileIndex<D> second, hn::Vec<D>& left,
                            hn::Vec<D>& right) {
    const hn::RebindToSigned<D> di;
    if (type == NumberType::Float) {
        left = hn::BitCast(d, first), right = hn::BitCast(d, second);
    } else if (type == NumberType::UInt16) {
        const hn::RebindToUnsigned<D> du;
        const auto high = hn::BitCast(di, hn::ShiftRight<16>(hn::BitCast(du, first)));
        const auto most = hn::Set(d, 65535.0F);
        left = hn::Div(hn::ConvertTo(d, hn::And(first, hn::Set(di, 0xFFFF))), most);
        right = hn::Div(hn::ConvertTo(d, high), most);
    } else {
        const auto byte = hn::Set(di, 0xFF);
        const auto most = hn::Set(d, 255.0F);
        left = hn::Div(hn::ConvertTo(d, hn::And(first, byte)), most);
        right = hn::Div(hn::ConvertTo(d, hn::And(hn::ShiftRight<8>(first), byte)), most);
    }
}
#endif

// Fetches the heights for those lanes of `who` whose four heights lie in one tile that is in use; returns these lanes.
// group, across: TileAccess::firstGroup and groupsAcross of each lane's level.
template <class D>
HWY_INLINE TileMask<D> heightsInTiles(D d, const TileAccess& access, TileMask<D> who, TileIndex<D> group,
                                      TileIndex<D> across, TileIndex<D> i0, TileIndex<D> i1, TileIndex<D> j0,
                                      TileIndex<D> j1, FourHeights<D>& out) {
    const hn::RebindToSigned<D> di;
    out.h00 = out.h10 = out.h01 = out.h11 = hn::Zero(d);
#if HWY_TARGET <= HWY_AVX2
    if (access.states == nullptr) return hn::MaskFromVec(hn::Zero(di));
    const auto one = hn::Set(di, 1), mask = hn::Set(di, kTileMask);
    const auto x = hn::And(i0, mask), y = hn::And(j0, mask);
    const auto next = hn::And(hn::Eq(i1, hn::Add(i0, one)), hn::Eq(j1, hn::Add(j0, one)));
    auto done = hn::And(hn::And(who, next), hn::And(hn::Ne(x, mask), hn::Ne(y, mask)));
    const auto tileX = hn::ShiftRight<kTileShift>(i0), tileY = hn::ShiftRight<kTileShift>(j0);
    group = hn::Add(group, hn::Add(hn::Mul(hn::ShiftRightSame(tileY, access.downShift), across),
                                   hn::ShiftRightSame(tileX, access.acrossShift)));
    const auto column = hn::And(tileX, hn::Set(di, (1 << access.acrossShift) - 1));
    const auto row = hn::And(tileY, hn::Set(di, (1 << access.downShift) - 1));
    const auto within = hn::Or(hn::ShiftLeftSame(row, access.acrossShift), column);
    const int bytesShift = access.tileBytesShift - 2 * kTileShift;
    const auto state = hn::Add(hn::ShiftLeft<kGroupShift - kStateShift>(group),
                               hn::ShiftLeftSame(within, access.tileBytesShift - kStateShift));
    const auto states =
        hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(access.states), hn::IfThenElseZero(done, state));
    done = hn::And(done, hn::Eq(hn::And(states, hn::Set(di, 0xFF)), hn::Set(di, TileAccess::kUsed)));
    if (hn::AllFalse(di, done)) return done;
    const auto index = hn::Or(hn::ShiftLeft<kTileShift>(y), x);
    const auto at = hn::IfThenElseZero(done, hn::ShiftLeftSame(index, bytesShift));
    const auto low = hn::IfThenElseZero(done, hn::ShiftLeftSame(within, access.tileBytesShift));
    group = hn::IfThenElseZero(done, group);
    TileIndex<D> first, second;
    tileWords(di, access, group, low, at, first, second);
    decodedPair(d, access.type, first, second, out.h00, out.h10);
    tileWords(di, access, group, low, hn::Add(at, hn::Set(di, kTileSide << bytesShift)), first, second);
    decodedPair(d, access.type, first, second, out.h01, out.h11);
    return done;
#else
    (void)access, (void)who, (void)group, (void)across, (void)i0, (void)i1, (void)j0, (void)j1;
    return hn::MaskFromVec(hn::Zero(di));
#endif
}

// The heights of the lanes `who`, for scenes whose heights are not gathered. The other lanes are unspecified.
template <class D, class Scene>
HWY_INLINE FourHeights<D> fourHeights(D d, const Scene& scene, TileMask<D> who, TileIndex<D> i0, TileIndex<D> i1,
                                      TileIndex<D> j0, TileIndex<D> j1) {
    const hn::RebindToSigned<D> di;
    constexpr std::size_t kCount = hn::MaxLanes(D());
    FourHeights<D> out;
    TileMask<D> done;
    if (scene.tiles != nullptr) {
        const TileAccess& access = scene.tiles->access();
        done = heightsInTiles(d, access, who, hn::Set(di, access.firstGroup[0]), hn::Set(di, access.groupsAcross[0]),
                              i0, i1, j0, j1, out);
        done = hn::Or(done, hn::Not(who));
        if (hn::AllTrue(di, done)) return out;
    } else {
        done = hn::Not(who);
        out.h00 = out.h10 = out.h01 = out.h11 = hn::Zero(d);
    }
    HWY_ALIGN std::int32_t known[kCount], left[kCount], right[kCount], top[kCount], bottom[kCount];
    HWY_ALIGN float h00[kCount], h10[kCount], h01[kCount], h11[kCount];
    hn::Store(hn::VecFromMask(di, done), di, known);
    hn::Store(i0, di, left), hn::Store(i1, di, right), hn::Store(j0, di, top), hn::Store(j1, di, bottom);
    hn::Store(out.h00, d, h00), hn::Store(out.h10, d, h10), hn::Store(out.h01, d, h01), hn::Store(out.h11, d, h11);
    for (std::size_t n = 0; n < kCount; ++n) {
        if (known[n] != 0) continue;
        const std::array<float, 4> four = scene.cornersAt(left[n], right[n], top[n], bottom[n]);
        h00[n] = four[0], h10[n] = four[1], h01[n] = four[2], h11[n] = four[3];
    }
    return {hn::Load(d, h00), hn::Load(d, h10), hn::Load(d, h01), hn::Load(d, h11)};
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
