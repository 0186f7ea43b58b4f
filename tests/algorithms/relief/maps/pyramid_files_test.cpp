#include "relief/maps/pyramid_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "algorithms/images/temporary_folder.h"
#include "algorithms/relief/fields.h"

namespace relief::test {
namespace {

// Other programs read the file as a picture with mip levels.
TEST(PyramidFiles, areReadAsMipLevelsElsewhere) {
    Work work;
    for (const std::string& name : pyramidMapKinds()) {
        for (const auto& [width, height] :
             std::vector<std::pair<int, int>>{{8, 8}, {100, 37}, {1, 1}, {1, 9}, {130, 3}}) {
            const Pyramid pyramid(pyramidKindOf(name), randomHeights(width, height, 5), work);
            const std::filesystem::path folder = std::filesystem::temp_directory_path() / "relief_pyramid_files";
            std::filesystem::create_directories(folder);
            const std::string path = (folder / (name + ".tif")).string();
            savePyramid(path, pyramid);
            std::ifstream file(path, std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(file), {}};
            const auto input = OIIO::ImageInput::open(path);
            ASSERT_TRUE(input);
            for (int l = 0; l < pyramid.levels(); ++l) {
                ASSERT_TRUE(input->seek_subimage(0, l)) << l;
                const OIIO::ImageSpec& spec = input->spec();
                const FloatImage& level = pyramid.level(l);
                ASSERT_EQ(spec.width, level.width());
                ASSERT_EQ(spec.height, level.height());
                EXPECT_EQ(spec.format, OIIO::TypeDesc::FLOAT);
                EXPECT_GT(spec.tile_width, 0);
                std::vector<float> numbers(level.size());
                ASSERT_TRUE(input->read_image(0, l, 0, 1, OIIO::TypeDesc::FLOAT, numbers.data()));
                EXPECT_TRUE(std::equal(numbers.begin(), numbers.end(), level.pixels().begin()));
                // OpenImageIO reads only the first level's description; in the file each page has its own.
                const std::string own = "\"level\":" + std::to_string(l) + ",\"levels\":";
                EXPECT_NE(bytes.find(own + std::to_string(pyramid.levels())), std::string::npos) << l;
                if (l > 0) continue;
                const auto header = nlohmann::json::parse(spec.get_string_attribute("ImageDescription").c_str());
                EXPECT_EQ(header.at("levels"), pyramid.levels());
                EXPECT_EQ(header.at("kind"), name == "max-pyramid" ? "max" : "mean");
            }
            EXPECT_NE(bytes.find("\"checksums\":["), std::string::npos);
            EXPECT_FALSE(input->seek_subimage(0, pyramid.levels()));
            std::filesystem::remove_all(folder);
        }
    }
}

}  // namespace
}  // namespace relief::test
