#include "images/picture_bytes.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "images/picture_bands.h"

namespace relief {

namespace {

using View = std::span<const unsigned char>;

std::uint32_t bigEndian(View bytes, std::size_t at) {
    return std::uint32_t{bytes[at]} << 24 | std::uint32_t{bytes[at + 1]} << 16 | std::uint32_t{bytes[at + 2]} << 8 |
           bytes[at + 3];
}

bool startsWith(View bytes, std::string_view text, std::size_t at = 0) {
    if (bytes.size() < at + text.size()) return false;
    return std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char c, unsigned char b) { return static_cast<unsigned char>(c) == b; });
}

struct Signature {
    std::string_view format;
    std::string_view text;
    std::size_t at = 0;
};

using namespace std::string_view_literals;

constexpr std::array kSignatures{
    Signature{"png", "\x89PNG\r\n\x1a\n"sv},
    Signature{"jpeg", "\xff\xd8\xff"sv},
    Signature{"tiff", "II*\0"sv},
    Signature{"tiff", "MM\0*"sv},
    Signature{"tiff", "II+\0"sv},
    Signature{"tiff", "MM\0+"sv},
    Signature{"openexr", "\x76\x2f\x31\x01"sv},
    Signature{"hdr", "#?RADIANCE"sv},
    Signature{"hdr", "#?RGBE"sv},
    Signature{"gif", "GIF87a"sv},
    Signature{"gif", "GIF89a"sv},
    Signature{"bmp", "BM"sv},
    Signature{"webp", "WEBP"sv, 8},
    Signature{"jpeg2000", "\0\0\0\x0cjP  "sv},
    Signature{"jpeg2000", "\xff\x4f\xff\x51"sv},
    Signature{"psd", "8BPS"sv},

    Signature{"fits", "SIMPLE  ="sv},
};

bool isPortableMap(View head) {
    const bool kind =
        head.size() > 2 && head[0] == 'P' && ((head[1] >= '1' && head[1] <= '6') || head[1] == 'F' || head[1] == 'f');
    return kind && (head[2] == ' ' || head[2] == '\t' || head[2] == '\n' || head[2] == '\r' || head[2] == '#');
}

// --- PNG

constexpr std::size_t kPngHead = 8;
constexpr std::size_t kPngFrame = 12;  // bytes: length, type and checksum around a chunk's data

// CRC-32 of ISO 3309, as PNG uses it, eight bytes per step.
class Checksum {
  public:
    Checksum() {
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
            tables_[0][n] = c;
        }
        for (std::size_t t = 1; t < 8; ++t)
            for (std::size_t n = 0; n < 256; ++n) {
                const std::uint32_t c = tables_[t - 1][n];
                tables_[t][n] = (c >> 8) ^ tables_[0][c & 0xffU];
            }
    }

    std::uint32_t of(View bytes) const {
        std::uint32_t c = 0xffffffffU;
        std::size_t i = 0;
        for (; i + 8 <= bytes.size(); i += 8) {
            const std::uint32_t low = c ^ (bytes[i] | std::uint32_t{bytes[i + 1]} << 8 |
                                           std::uint32_t{bytes[i + 2]} << 16 | std::uint32_t{bytes[i + 3]} << 24);
            c = tables_[7][low & 0xffU] ^ tables_[6][(low >> 8) & 0xffU] ^ tables_[5][(low >> 16) & 0xffU] ^
                tables_[4][low >> 24] ^ tables_[3][bytes[i + 4]] ^ tables_[2][bytes[i + 5]] ^ tables_[1][bytes[i + 6]] ^
                tables_[0][bytes[i + 7]];
        }
        for (; i < bytes.size(); ++i) c = (c >> 8) ^ tables_[0][(c ^ bytes[i]) & 0xffU];
        return ~c;
    }

  private:
    std::array<std::array<std::uint32_t, 256>, 8> tables_{};
};

// Decides for each PNG chunk whether the pixels need it, and whether the order of chunks is valid.
class PngGrammar {
  public:
    enum class Verdict : std::uint8_t { Keep, Drop, Damaged };

    Verdict judge(std::string_view type, View data) {
        if (type == "IHDR") return keepIf(header(data));
        if (colorType_ < 0) return Verdict::Damaged;
        if (type == "PLTE") return colorType_ == 3 ? keepIf(palette(data)) : Verdict::Drop;
        if (type == "IDAT") return keepIf(data_ = colorType_ != 3 || palette_);
        if (type == "IEND") return keepIf(data_);
        if ((static_cast<unsigned char>(type[0]) & 0x20U) == 0) return Verdict::Damaged;  // an unknown critical chunk
        const bool needed = type == "tRNS" || type == "sRGB" || type == "gAMA" || (type == "tEXt" && ofOurs(data));
        return needed && !data_ ? Verdict::Keep : Verdict::Drop;
    }

  private:
    static Verdict keepIf(bool fits) { return fits ? Verdict::Keep : Verdict::Damaged; }

    // The text of a band, or the description of a map: what this program wrote, and no other text.
    static bool ofOurs(View data) {
        const std::size_t end = kBandAttribute.size();
        if (startsWith(data, kBandAttribute) && data.size() > end && data[end] == 0) return true;
        return startsWith(data, "Description\0{\"format\":\"reliefscope"sv);
    }

    bool header(View data) {
        if (colorType_ >= 0 || data.size() != 13) return false;
        const std::uint32_t width = bigEndian(data, 0);
        const std::uint32_t height = bigEndian(data, 4);
        bits_ = data[8];
        const int type = data[9];
        const bool power = bits_ == 1 || bits_ == 2 || bits_ == 4 || bits_ == 8 || bits_ == 16;
        const bool fits =
            type == 0 || (type == 3 && bits_ <= 8) || ((type == 2 || type == 4 || type == 6) && bits_ >= 8);
        if (!power || !fits || data[10] != 0 || data[11] != 0 || data[12] > 1) return false;
        if (width == 0 || height == 0 || (width | height) > 0x7fffffffU) return false;
        colorType_ = type;
        return true;
    }

    bool palette(View data) {
        if (data_ || palette_ || data.empty() || data.size() % 3 != 0) return false;
        return palette_ = data.size() / 3 <= std::size_t{1} << bits_;
    }

    int bits_ = 0;
    int colorType_ = -1;
    bool data_ = false;
    bool palette_ = false;
};

}  // namespace

std::string_view formatBySignature(std::span<const unsigned char> head) {
    for (const Signature& signature : kSignatures)
        if (startsWith(head, signature.text, signature.at)) return signature.format;
    return isPortableMap(head) ? "pnm" : "";
}

std::optional<DeclaredSize> declaredSize(std::string_view format, std::span<const unsigned char> head) {
    if (format == "png" && head.size() >= 24 && startsWith(head, "IHDR", 12))
        return DeclaredSize{bigEndian(head, 16), bigEndian(head, 20)};
    if (format == "gif" && head.size() >= 10)
        return DeclaredSize{head[6] | std::uint32_t{head[7]} << 8, head[8] | std::uint32_t{head[9]} << 8};
    if (format != "jpeg2000") return std::nullopt;
    for (std::size_t i = 0; i + 24 <= head.size(); ++i) {
        if (!startsWith(head, "\xff\x4f\xff\x51"sv, i)) continue;
        const std::uint32_t left = bigEndian(head, i + 16);
        const std::uint32_t top = bigEndian(head, i + 20);
        const std::uint32_t right = bigEndian(head, i + 8);
        const std::uint32_t bottom = bigEndian(head, i + 12);
        return DeclaredSize{right > left ? right - left : 0, bottom > top ? bottom - top : 0};
    }
    return std::nullopt;
}

std::optional<Bytes> cleanPng(std::span<const unsigned char> file) {
    const Checksum checksum;
    PngGrammar grammar;
    Bytes clean;
    clean.reserve(file.size());
    const auto keep = [&](View bytes) { clean.insert(clean.end(), bytes.begin(), bytes.end()); };
    if (file.size() < kPngHead) return std::nullopt;
    keep(file.first(kPngHead));
    std::size_t at = kPngHead;
    while (file.size() - at >= kPngFrame) {
        const std::size_t length = bigEndian(file, at);
        if (length > file.size() - at - kPngFrame) return std::nullopt;
        const View chunk = file.subspan(at, length + kPngFrame);
        const View typed = chunk.subspan(4, 4 + length);
        const std::string_view type(reinterpret_cast<const char*>(typed.data()), 4);
        at += chunk.size();
        if (checksum.of(typed) != bigEndian(chunk, chunk.size() - 4)) {
            // An invalid chunk matters only if it is critical (the case bit of its type).
            if ((typed[0] & 0x20U) == 0) return std::nullopt;
            continue;
        }
        const PngGrammar::Verdict verdict = grammar.judge(type, typed.subspan(4));
        if (verdict == PngGrammar::Verdict::Damaged) return std::nullopt;
        if (verdict == PngGrammar::Verdict::Keep) keep(chunk);
        if (type == "IEND") return clean;
    }
    return std::nullopt;
}

}  // namespace relief
