#include "images/height_rows.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include <nlohmann/json.hpp>

#include "images/height_scaling.h"
#include "relief/memory.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSurveyRows = 64;

class PictureHeightRows final : public HeightRows {
  public:
    PictureHeightRows(const std::string& path, const HeightReadOptions& options)
        : path_(path),
          options_(options),
          input_(path, std::numeric_limits<std::int64_t>::max(), PictureAccess::Rows),
          channel_(chosenChannel(input_, options.channel)),
          sampleType_(input_.type(channel_)) {
        const bool unsignedCodes = sampleType_ == NumberType::UInt8 || sampleType_ == NumberType::UInt16;
        codes_ = unsignedCodes && !options.invert && options.range.kind != HeightRange::Kind::Bounds;
    }

    int width() const override { return input_.info().width; }
    int height() const override { return input_.info().height; }
    NumberType type() const override { return codes_ ? sampleType_ : NumberType::Float; }
    std::string identity() const override;
    std::string learned() const override;
    void restore(const std::string& learned) override;
    void prepare(Work& work) override;
    void read(int first, int count, std::byte* rows, Work& work) override;
    std::vector<Message> notes() const override;

  private:
    bool needsSurvey() const { return fullRange(sampleType_) <= 0 && options_.range.kind != HeightRange::Kind::Bounds; }
    void surveyRows(int first, int count, Work& work);
    std::byte* samples(int count);

    std::string path_;
    HeightReadOptions options_;
    PictureInput input_;
    int channel_;
    NumberType sampleType_;
    bool codes_ = false;
    Survey survey_;
    HeightScaling scaling_;
    std::vector<std::byte> buffer_;
};

std::string PictureHeightRows::identity() const {
    struct stat status {};
    static_cast<void>(::stat(path_.c_str(), &status));
    return Json{{"picture", path_},
                {"bytes", status.st_size},
                {"modified", {status.st_mtim.tv_sec, status.st_mtim.tv_nsec}},
                {"channel", channel_},
                {"invert", options_.invert},
                {"range", heightRangeText(options_.range)}}
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string PictureHeightRows::learned() const {
    // Infinite until a sample has been seen, which JSON has no numbers for.
    return Json{{"low", numberText(survey_.low)}, {"high", numberText(survey_.high)}, {"outside", survey_.outside}}
        .dump();
}

void PictureHeightRows::restore(const std::string& learned) {
    const Json json = Json::parse(learned);
    const auto number = [&](const char* name, double& value) {
        const std::string text = json.at(name).get<std::string>();
        std::from_chars(text.data(), text.data() + text.size(), value);
    };
    number("low", survey_.low);
    number("high", survey_.high);
    survey_.outside = json.at("outside").get<std::size_t>();
    std::vector<Message> ignored;
    scaling_ = chosenScaling(options_, sampleType_, survey_, path_, ignored);
}

// Makes place for the samples of `count` rows.
std::byte* PictureHeightRows::samples(int count) {
    const std::uint64_t bytes =
        byteProduct({static_cast<std::uint64_t>(width()), static_cast<std::uint64_t>(count), numberBytes(sampleType_)});
    if (buffer_.size() < bytes) {
        requireMemory(bytes, path_, MemoryHint::SmallerPicture);
        buffer_.resize(bytes);
    }
    return buffer_.data();
}

// Adds the rows in the buffer to the survey.
void PictureHeightRows::surveyRows(int first, int count, Work& work) {
    const auto across = static_cast<std::size_t>(width());
    const RawPlane plane{buffer_.data(), 1, sampleType_};
    const Survey found =
        survey(plane, across * static_cast<std::size_t>(count), sampleBounds(options_.range, sampleType_), work);
    if (!found.finite())
        throw notFinite(plane, found.firstBad, found.firstBad % across,
                        static_cast<std::size_t>(first) + found.firstBad / across, path_);
    survey_ = merged(survey_, found);
}

void PictureHeightRows::prepare(Work& work) {
    if (needsSurvey()) {
        work.progress().begin("range", height());
        for (int y = 0; y < height(); y += kSurveyRows) {
            const int count = std::min(kSurveyRows, height() - y);
            input_.readRows(channel_, y, count, samples(count));
            surveyRows(y, count, work);
            work.progress().advance(count);
        }
    }
    std::vector<Message> ignored;
    scaling_ = chosenScaling(options_, sampleType_, survey_, path_, ignored);
}

void PictureHeightRows::read(int first, int count, std::byte* rows, Work& work) {
    if (codes_) return input_.readRows(channel_, first, count, rows);
    const RawPlane plane{samples(count), 1, sampleType_};
    input_.readRows(channel_, first, count, buffer_.data());
    if (!needsSurvey()) surveyRows(first, count, work);
    const std::span<float> out(reinterpret_cast<float*>(rows),
                               static_cast<std::size_t>(width()) * static_cast<std::size_t>(count));
    scale(plane, scaling_, out, work);
}

std::vector<Message> PictureHeightRows::notes() const {
    std::vector<Message> notes;
    if (!codes_) static_cast<void>(chosenScaling(options_, sampleType_, survey_, path_, notes));
    return notes;
}

}  // namespace

std::unique_ptr<HeightRows> pictureHeightRows(const std::string& path, const HeightReadOptions& options) {
    return std::make_unique<PictureHeightRows>(path, options);
}

}  // namespace relief
