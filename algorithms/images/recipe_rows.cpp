#include "images/recipe_rows.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "relief/errors.h"
#include "relief/memory.h"

namespace relief {

namespace {

class ReliefHeightRows final : public HeightRows {
  public:
    ReliefHeightRows(std::string_view name, int width, int height, std::uint64_t seed)
        : rows_(recipeRows(name, width, height, seed)), name_(name), width_(width), height_(height), seed_(seed) {}

    int width() const override { return width_; }
    int height() const override { return height_; }
    NumberType type() const override { return rows_->codes() ? NumberType::UInt16 : NumberType::Float; }
    std::string identity() const override {
        return nlohmann::ordered_json{{"relief", name_}, {"size", {width_, height_}}, {"seed", seed_}}.dump();
    }
    std::string learned() const override { return rows_->learned(); }
    void restore(const std::string& learned) override { rows_->restore(learned); }
    void prepare(Work& work) override {
        if (rows_->passes() > 1) work.progress().begin("range", height_);
        rows_->prepare(work, [&] { work.progress().advance(); });
    }
    void read(int first, int count, std::byte* rows, Work& work) override {
        const auto across = static_cast<std::size_t>(width_);
        parallelFor(work, count, [&](int y) {
            const std::size_t at = across * static_cast<std::size_t>(y);
            if (!rows_->codes()) return rows_->row(first + y, reinterpret_cast<float*>(rows) + at);
            std::vector<float> heights(across);
            rows_->row(first + y, heights.data());
            auto* const codes = reinterpret_cast<std::uint16_t*>(rows) + at;
            for (std::size_t x = 0; x < across; ++x)
                codes[x] = static_cast<std::uint16_t>(static_cast<double>(heights[x]) * 65535 + 0.5);
        });
    }
    std::vector<Message> notes() const override { return {}; }

  private:
    std::unique_ptr<RecipeRows> rows_;
    std::string name_;
    int width_, height_;
    std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<HeightRows> reliefHeightRows(std::string_view name, int width, int height, std::uint64_t seed) {
    return std::make_unique<ReliefHeightRows>(name, width, height, seed);
}

FloatImage makeRelief(std::string_view name, int width, int height, std::uint64_t seed, Work* given) {
    const auto rows = recipeRows(name, width, height, seed);
    requireMemory(byteProduct({static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), sizeof(float)}),
                  std::string(name) + ":" + std::to_string(width) + "x" + std::to_string(height),
                  MemoryHint::SmallerSize);
    std::optional<Work> own;
    Work& work = given != nullptr ? *given : own.emplace(1);
    const auto rowDone = [&] { work.progress().advance(); };
    work.progress().begin("making the relief", std::int64_t{rows->passes()} * height);
    rows->prepare(work, rowDone);
    FloatImage out(width, height);
    parallelFor(work, height, [&](int y) {
        rows->row(y, out.row(y).data());
        rowDone();
    });
    return out;
}

}  // namespace relief
