// Maps in files: reading gives the same bits, anything else is refused; interrupted builds leave nothing behind.
#include "algorithms/images/temporary_folder.h"
#include "algorithms/relief/fields.h"
#include "images/described_tiff.h"
#include "images/picture_input.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"

#include <gtest/gtest.h>

namespace relief::test {

namespace {

using relief::testing::bytesOf;
using relief::testing::faultOf;
using relief::testing::TemporaryFolder;

constexpr std::size_t kPlenty = std::size_t{1} << 24;

HeightField smallField(Surface surface = Surface::Bilinear, Address address = Address::Repeat) {
    return {randomHeights(13, 9, 5), surface, address, 0.3};
}

// Every kind of map in every precision; with several sectors where possible.
std::vector<MethodChoice> storedChoices() {
    std::vector<MethodChoice> all;
    for (const std::string& kind : mapKinds()) {
        for (const char* precision : {"float", "u16", "u8"}) {
            MethodChoice choice{methodOfMap(kind), {{"precision", precision}}};
            if (kind == "cone") choice.options["sectors"] = "4";
            if (kind == "refined") choice.options["sectors"] = "2";
            if (kind.starts_with("refined")) choice.options["footprint"] = "3";
            if (choice.name.starts_with("distance")) choice.options["layers"] = "7";
            all.push_back(choice);
        }
    }
    return all;
}

std::string kindOf(const MethodChoice& choice) {
    return findTracer(choice.name).maps.front();
}

void expectSame(const StoredValues& a, const StoredValues& b) {
    EXPECT_EQ(a.width(), b.width());
    EXPECT_EQ(a.height(), b.height());
    EXPECT_EQ(a.layers(), b.layers());
    EXPECT_EQ(a.unit(), b.unit());
    EXPECT_EQ(a.codes(), b.codes());
}

void expectSame(const DistanceMap& a, const DistanceMap& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.parameters, b.parameters);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.address, b.address);
    EXPECT_EQ(a.fieldWidth, b.fieldWidth);
    EXPECT_EQ(a.fieldHeight, b.fieldHeight);
    EXPECT_EQ(a.slabTexels, b.slabTexels);
    EXPECT_EQ(a.maxRun, b.maxRun);
    EXPECT_EQ(a.cap, b.cap);
    expectSame(a.values, b.values);
}

void expectSame(const ConeMap& a, const ConeMap& b) {
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.parameters, b.parameters);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.address, b.address);
    expectSame(a.apex, b.apex);
    expectSame(a.slopes, b.slopes);
}

void expectSame(const StoredMap& a, const StoredMap& b) {
    ASSERT_EQ(a.index(), b.index());
    if (a.index() == 0) {
        expectSame(*std::get<0>(a), *std::get<0>(b));
    } else {
        expectSame(*std::get<1>(a), *std::get<1>(b));
    }
}

StoredMap refinedMap(const HeightField& field) {
    MapCache cache;
    Work work;
    return buildMap("refined", {}, field, cache, work);
}

std::string loadFault(const std::string& path, const HeightField& field, std::size_t most = kPlenty) {
    Work work;
    return faultOf([&] { (void)loadMap(path, field, most, work); });
}

void expectPart(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << " lacks " << part;
}

}  // namespace

TEST(MapFiles, SameBitsOfEveryKind) {
    const TemporaryFolder folder;
    Work work;
    for (const Surface surface : allSurfaces()) {
        for (const Address address : {Address::Repeat, Address::Border}) {
            const HeightField field = smallField(surface, address);
            for (const MethodChoice& choice : storedChoices()) {
                if (!supports({choice.name, {}}, surface, address)) continue;
                SCOPED_TRACE(kindOf(choice) + " " + choice.options.at("precision"));
                MapCache cache;
                const StoredMap built = buildMap(kindOf(choice), choice.options, field, cache, work);
                saveMap(folder / "map.tif", built, field.heights());
                expectSame(loadMap(folder / "map.tif", field, kPlenty, work), built);
            }
        }
    }
    EXPECT_EQ(folder.files(), 1);
}

TEST(MapFiles, AReliefWithoutDepthIsReadBack) {
    const TemporaryFolder folder;
    Work work;
    const HeightField field(randomHeights(13, 9, 5), Surface::Bilinear, Address::Repeat, 0);
    for (const std::string& kind : mapKinds()) {
        MapCache cache;
        saveMap(folder / "map.tif", buildMap(kind, {}, field, cache, work), field.heights());
        EXPECT_EQ(loadFault(folder / "map.tif", field), "") << kind;
    }
}

// Distances are rounded down, cone slopes up, so that values never exceed those of float.
TEST(MapFiles, CoarserValuesLieOnTheSafeSide) {
    Work work;
    const auto values = [](const StoredMap& map) -> std::vector<const StoredValues*> {
        if (const auto* distances = std::get_if<std::shared_ptr<const DistanceMap>>(&map))
            return {&(*distances)->values};
        const auto& cones = std::get<std::shared_ptr<const ConeMap>>(map);
        return {&cones->apex, &cones->slopes};
    };
    FloatImage low = smallField().heights();
    for (float& h : low.pixels()) h *= 0.5F;  // voxels above are free
    const HeightField field(share(std::move(low)), Surface::Bilinear, Address::Repeat, 0.3);
    for (const MethodChoice& choice : storedChoices()) {
        SCOPED_TRACE(kindOf(choice) + " " + choice.options.at("precision"));
        OptionValues options = choice.options;
        MapCache cache;
        const StoredMap coarse = buildMap(kindOf(choice), options, field, cache, work);
        options["precision"] = "float";
        const StoredMap fine = buildMap(kindOf(choice), options, field, cache, work);
        const float sign = values(fine).size() == 1 ? 1.0F : -1.0F;
        int rounded = 0;
        for (std::size_t part = 0; part < values(fine).size(); ++part) {
            const StoredValues& a = *values(coarse)[part];
            const StoredValues& b = *values(fine)[part];
            for (int k = 0; k < b.layers(); ++k) {
                for (int y = 0; y < b.height(); ++y) {
                    for (int x = 0; x < b.width(); ++x) {
                        ASSERT_LE(sign * a(x, y, k), sign * b(x, y, k)) << x << ", " << y << ", " << k;
                        rounded += a(x, y, k) != b(x, y, k) ? 1 : 0;
                    }
                }
            }
        }
        EXPECT_EQ(rounded > 0, choice.options.at("precision") != "float");
    }
}

TEST(MapFiles, TracersUseTheStoredMap) {
    const TemporaryFolder folder;
    Work work;
    const HeightField field = smallField();
    for (const MethodChoice& choice : storedChoices()) {
        SCOPED_TRACE(kindOf(choice) + " " + choice.options.at("precision"));
        MapCache building;
        const StoredMap built = buildMap(kindOf(choice), choice.options, field, building, work);
        saveMap(folder / "map.tif", built, field.heights());
        const StoredMap stored = loadMap(folder / "map.tif", field, kPlenty, work);
        for (const std::string outer : {"", "hybrid"}) {
            Work counting;
            MapCache cache;
            MethodChoice asked{choice.name, {}};
            if (!outer.empty()) {
                // Marks only the bottom level, so that the hybrid builds an additional map.
                asked = {outer, {{"inner", choice.name}}};
            }
            const MethodChoice chosen = useMap(folder / "map.tif", stored, asked, field, cache);
            const auto tracer = makeTracer(chosen, field, cache, counting);
            EXPECT_EQ(counting.counters().values()[MessageId::CountMapBuilds], outer.empty() ? 0 : 1);
            EXPECT_EQ(chosen.options.at((outer.empty() ? "" : "inner.") + std::string("precision")),
                      choice.options.at("precision"));
        }
    }
}

TEST(MapFiles, AnotherFieldIsRefused) {
    const TemporaryFolder folder;
    const std::string path = folder / "map.tif";
    const HeightField field = smallField();
    saveMap(path, refinedMap(field), field.heights());
    EXPECT_EQ(loadFault(path, field), "");

    FloatImage other = field.heights();
    other(3, 4) = std::nextafter(other(3, 4), 1.0F);
    expectPart(loadFault(path, {share(other), Surface::Bilinear, Address::Repeat, 0.3}), "another height map");
    // The same number of texels with the same bits, in another shape.
    FloatImage turned(9, 13);
    std::copy(field.heights().pixels().begin(), field.heights().pixels().end(), turned.pixels().begin());
    expectPart(loadFault(path, {share(turned), Surface::Bilinear, Address::Repeat, 0.3}), "another height map");
    expectPart(loadFault(path, {field.sharedHeights(), Surface::Columns, Address::Repeat, 0.3}),
               "surface bilinear, not columns");
    expectPart(loadFault(path, {field.sharedHeights(), Surface::Bilinear, Address::Border, 0.3}),
               "address repeat, not border");
    expectPart(loadFault(path, {field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.2}),
               "relief-depth 0.3, not 0.2");
}

TEST(MapFiles, AnyDepthServesCones) {
    const TemporaryFolder folder;
    const HeightField field = smallField();
    MapCache cache;
    Work work;
    saveMap(folder / "map.tif", buildMap("cone", {}, field, cache, work), field.heights());
    EXPECT_EQ(loadFault(folder / "map.tif", {field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.2}), "");
}

TEST(MapFiles, AnotherVersionOrPictureIsRefused) {
    const TemporaryFolder folder;
    const std::string path = folder / "map.tif";
    const HeightField field = smallField();
    saveMap(path, refinedMap(field), field.heights());
    PictureInput input(path, std::int64_t{1} << 20);
    std::string text = input.description();
    const PictureCodes codes(std::vector<float>(static_cast<std::size_t>(input.info().width) *
                                                static_cast<std::size_t>(input.info().height)));
    const auto written = [&](const std::string& description) {
        writeDescribedTiff(folder / "other.tif", input.info().width, input.info().height, codes, description);
        return loadFault(folder / "other.tif", field);
    };
    expectPart(written(text), "damaged: codes");
    const std::size_t at = text.find("\"version\":1");
    ASSERT_NE(at, std::string::npos);
    expectPart(written(text.substr(0, at) + "\"version\":2" + text.substr(at + 11)), "version 2");
    expectPart(written("{\"format\":\"reliefscope map\"}"), "version null");
    expectPart(written("a picture of a cat"), "not a stored map");
    expectPart(written("{\"a\":1}"), "not a stored map");
    expectPart(written(text.substr(0, text.size() / 2)), "damaged");
    writeHeight(folder / "heights.png", field.heights());
    expectPart(loadFault(folder / "heights.png", field), "not a stored map");
    EXPECT_NE(loadFault(folder / "nothing.tif", field), "");
}

// Every field of the description is covered by its checksum: any changed number is detected.
TEST(MapFiles, AlteredDescriptionsAreRefused) {
    const TemporaryFolder folder;
    const std::string path = folder / "map.tif";
    const HeightField field = smallField();
    saveMap(path, refinedMap(field), field.heights());
    PictureInput input(path, std::int64_t{1} << 20);
    const std::string text = input.description();
    int altered = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] < '0' || text[i] > '9') continue;
        std::string other = text;
        other[i] = other[i] == '9' ? '8' : static_cast<char>(other[i] + 1);
        writeDescribedTiff(folder / "other.tif", input.info().width, input.info().height,
                           PictureCodes(std::vector<float>(static_cast<std::size_t>(input.info().width) *
                                                           static_cast<std::size_t>(input.info().height))),
                           other);
        const std::string fault = loadFault(folder / "other.tif", field);
        EXPECT_TRUE(fault.find("damaged: description") != std::string::npos ||
                    fault.find("version 2") != std::string::npos)
            << i << ": " << fault;
        ++altered;
    }
    EXPECT_GT(altered, 50);
}

// A byte changed at any position: the file is refused with a message, or the map is the same (padding, a date); never a
// crash.
TEST(MapFiles, DamagedAndTruncatedFilesAreRefused) {
    const TemporaryFolder folder;
    const HeightField field = smallField();
    const StoredMap whole = refinedMap(field);
    saveMap(folder / "map.tif", whole, field.heights());
    const std::string bytes = bytesOf(folder / "map.tif");
    Work work;
    int refused = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 7) {
        std::string other = bytes;
        other[i] = static_cast<char>(other[i] ^ 0x10);
        const std::string path = folder.with("other.tif", other);
        const std::string fault = loadFault(path, field);
        if (fault.empty()) {
            expectSame(loadMap(path, field, kPlenty, work), whole);
        } else {
            ++refused;
        }
    }
    EXPECT_GT(refused, static_cast<int>(bytes.size() / 7 / 2));
    for (std::size_t kept = 0; kept < bytes.size(); kept += 1 + bytes.size() / 40) {
        EXPECT_NE(loadFault(folder.with("cut.tif", bytes.substr(0, kept)), field), "") << kept;
    }
}

TEST(MapFiles, AnotherMethodOrOptionIsRefused) {
    const HeightField field = smallField();
    const StoredMap map = refinedMap(field);
    const auto fault = [&](const MethodChoice& choice) {
        MapCache cache;
        const std::string text = faultOf([&] { (void)useMap("map.tif", map, choice, field, cache); });
        EXPECT_EQ(cache.bytes() == 0, !text.empty());
        return text;
    };
    EXPECT_EQ(fault({"distance-refined", {}}), "");
    EXPECT_EQ(fault({"distance-refined", {{"layers", "16.0"}}}), "");
    expectPart(fault({"distance-refined", {{"layers", "8"}}}), "layers 16, not 8");
    expectPart(fault({"cone", {}}), "cone needs the map cone; this is refined");
    expectPart(fault({"distance-refined-sampled", {}}), "needs the map refined-sampled; this is refined");
    expectPart(fault({"exact", {}}), "this is refined");
    expectPart(fault({"hybrid", {{"inner", "layers"}}}), "this is refined");
    EXPECT_EQ(fault({"hybrid", {}}), "") << "inside it the unchanged tracer takes the refined map";
}

TEST(MapFiles, TooLargeIsRefusedBeforeAllocating) {
    const TemporaryFolder folder;
    const HeightField field = smallField();
    const StoredMap map = refinedMap(field);
    saveMap(folder / "map.tif", map, field.heights());
    EXPECT_EQ(loadFault(folder / "map.tif", field, kPlenty), "");
    EXPECT_NE(loadFault(folder / "map.tif", field, mapBytes(map) / 8), "");
    // Would need 1 TB; the test fails if it were allocated before the check.
    const HeightField large(constantHeights(16384, 16384, 0.5F));
    for (const std::string& kind : mapKinds()) {
        MapCache cache(1 << 20);
        Work work;
        OptionValues options;
        if (methodOfMap(kind).starts_with("distance")) options = {{"footprint", "1"}, {"layers", "1024"}};
        expectPart(faultOf([&] { (void)buildMap(kind, options, large, cache, work); }), "MiB");
        EXPECT_EQ(cache.bytes(), 0U);
    }
}

TEST(MapFiles, CancelledBuildsLeaveNothing) {
    const HeightField field(randomHeights(96, 96, 3), Surface::Bilinear, Address::Repeat, 0.2);
    for (const std::string& kind : mapKinds()) {
        SCOPED_TRACE(kind);
        std::stop_source stop;
        MapCache cache;
        bool begun = false;
        // Cancelled from the progress callback, after part of the build.
        Work work(2, stop.get_token(), [&](std::string_view, double fraction) {
            begun = true;
            if (fraction > 0) stop.request_stop();
        });
        EXPECT_THROW((void)buildMap(kind, {}, field, cache, work), Cancelled);
        EXPECT_TRUE(begun);
        EXPECT_EQ(cache.bytes(), 0U);
        // The next request builds a complete map.
        Work again;
        const StoredMap map = buildMap(kind, {}, field, cache, again);
        EXPECT_EQ(cache.bytes(), mapBytes(map) + field.heights().bytes());
        MapCache fresh;
        expectSame(map, buildMap(kind, {}, field, fresh, again));
    }
}

TEST(MapFiles, usedMapsAreThoseOfTheMethod) {
    for (const MethodDescription& method : tracerList()) {
        const auto used = usedMap({method.name, {}});
        bool stored = false;
        for (const std::string& kind : mapKinds()) {
            stored = stored || std::find(method.maps.begin(), method.maps.end(), kind) != method.maps.end();
        }
        if (method.name != "hybrid") {
            ASSERT_EQ(used.has_value(), stored) << method.name;
        }
        if (!stored) continue;
        EXPECT_NE(std::find(method.maps.begin(), method.maps.end(), used->kind), method.maps.end()) << method.name;
        for (const auto& [name, value] : method.defaults) EXPECT_EQ(used->options.at(name), value) << method.name;
    }
    const auto inner = usedMap({"hybrid", {{"inner", "cone"}, {"inner.sectors", "4"}}});
    ASSERT_TRUE(inner);
    EXPECT_EQ(inner->kind, "cone");
    EXPECT_EQ(inner->options.at("sectors"), "4");
    EXPECT_EQ(usedMap({"distance-conservative", {{"map", "refined"}}})->kind, "refined") << "another map is given";
    for (const Address address : {Address::Repeat, Address::Clamp}) {
        EXPECT_EQ(supports({"hybrid", {{"inner", "distance-conservative"}, {"inner.map", "refined"}}},
                           Surface::Bilinear, address),
                  address == Address::Repeat)
            << "no refined map is made under clamp";
    }
}

}  // namespace relief::test
