// Small pictures written byte by byte, so that the tests do not depend on the library that they test.
#include <bit>
#include <cstring>

#include "command_test.h"

namespace relief::test {

namespace {

void little(std::string& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

void big(std::string& out, std::uint32_t value) {
    for (int i = 3; i >= 0; --i) out += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

void text(std::string& out, const char* characters) {
    out.append(characters, std::strlen(characters) + 1);
}

void attribute(std::string& out, const char* name, const char* type, const std::string& value) {
    text(out, name);
    text(out, type);
    little(out, value.size(), 4);
    out += value;
}

std::uint32_t crc(const std::string& bytes) {
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        value ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~value;
}

}  // namespace

std::string exrBytes(int width, int height, const std::vector<float>& values) {
    const auto one = std::bit_cast<std::uint32_t>(1.0F);
    std::string channels;
    text(channels, "Y");
    little(channels, 2, 4);  // float
    little(channels, 0, 4);
    little(channels, 1, 4);
    little(channels, 1, 4);
    channels += '\0';
    std::string window;
    little(window, 0, 8);
    little(window, static_cast<std::uint32_t>(width - 1), 4);
    little(window, static_cast<std::uint32_t>(height - 1), 4);
    std::string number;
    little(number, one, 4);
    std::string out("\x76\x2f\x31\x01\x02\0\0\0", 8);
    attribute(out, "channels", "chlist", channels);
    attribute(out, "compression", "compression", std::string(1, '\0'));
    attribute(out, "dataWindow", "box2i", window);
    attribute(out, "displayWindow", "box2i", window);
    attribute(out, "lineOrder", "lineOrder", std::string(1, '\0'));
    attribute(out, "pixelAspectRatio", "float", number);
    attribute(out, "screenWindowCenter", "v2f", std::string(8, '\0'));
    attribute(out, "screenWindowWidth", "float", number);
    out += '\0';
    const std::size_t rowBytes = 8 + 4 * static_cast<std::size_t>(width);
    const std::size_t first = out.size() + 8 * static_cast<std::size_t>(height);
    for (int y = 0; y < height; ++y) little(out, first + static_cast<std::size_t>(y) * rowBytes, 8);
    for (int y = 0; y < height; ++y) {
        little(out, static_cast<std::uint32_t>(y), 4);
        little(out, 4 * static_cast<std::uint64_t>(width), 4);
        for (int x = 0; x < width; ++x) {
            little(out, std::bit_cast<std::uint32_t>(values[static_cast<std::size_t>(y * width + x)]), 4);
        }
    }
    return out;
}

std::string pngHeaderBytes(std::uint32_t width, std::uint32_t height) {
    std::string chunk = "IHDR";
    big(chunk, width);
    big(chunk, height);
    chunk += std::string("\x08\0\0\0\0", 5);
    std::string out("\x89PNG\r\n\x1a\n", 8);
    big(out, 13);
    out += chunk;
    big(out, crc(chunk));
    return out;
}

}  // namespace relief::test
