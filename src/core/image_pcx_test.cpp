// SPDX-License-Identifier: MIT
#include "core/image_pcx.h"

#include <vector>

#include <gtest/gtest.h>
#include <ombrage/error.h>

namespace ombrage {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes head(int width, int height, int planes, int stride) {
    Bytes bytes(128, 0);
    bytes[0] = 0x0a;
    bytes[1] = 5;
    bytes[2] = 1;
    bytes[3] = 8;
    const auto word = [&](std::size_t at, int value) {
        bytes[at] = (unsigned char)(value & 255);
        bytes[at + 1] = (unsigned char)(value >> 8);
    };
    word(8, width - 1);
    word(10, height - 1);
    bytes[65] = (unsigned char)planes;
    word(66, stride);
    return bytes;
}

void append(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

/// 3 x 2 pixels of a palette: 1 1 200 / 2 0xc5 1, lines padded to 4 bytes; the first run crosses nothing.
Bytes paletted() {
    Bytes bytes = head(3, 2, 1, 4);
    append(bytes, {0xc2, 1, 0xc1, 200, 0, 2, 0xc1, 0xc5, 1, 0});
    bytes.push_back(12);
    for (int i = 0; i < 256; ++i) append(bytes, {(unsigned char)i, (unsigned char)(255 - i), 7});
    return bytes;
}

std::string refusal(const Bytes& bytes) {
    try {
        decodeImage(bytes, "x.pcx");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Input);
        EXPECT_EQ(error.where(), "x.pcx");
        return error.message();
    }
    ADD_FAILURE() << "no error";
    return {};
}

TEST(Pcx, RunsAndPalette) {
    const Image image = decodeImage(paletted(), "x.pcx");
    ASSERT_EQ(image.width(), 3);
    ASSERT_EQ(image.height(), 2);
    EXPECT_EQ(image.colorSpace(), ColorSpace::Srgb);
    const int expected[2][3] = {{1, 1, 200}, {2, 0xc5, 1}};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            EXPECT_EQ(image.at(0, x, y), float(expected[y][x]) / 255.0f);
            EXPECT_EQ(image.at(1, x, y), float(255 - expected[y][x]) / 255.0f);
            EXPECT_EQ(image.at(2, x, y), 7.0f / 255.0f);
        }
}

TEST(Pcx, ThreePlanesAndRunsAcrossLines) {
    Bytes bytes = head(2, 2, 3, 2);
    // Line 0: red 10 10, green 20 20, blue 20 20 (one run of four); line 1: six times 30.
    append(bytes, {0xc2, 10, 0xc4, 20, 0xc6, 30});
    const Image image = decodeImage(bytes, "x.pcx");
    EXPECT_EQ(image.at(0, 1, 0), 10.0f / 255.0f);
    EXPECT_EQ(image.at(1, 0, 0), 20.0f / 255.0f);
    EXPECT_EQ(image.at(2, 1, 0), 20.0f / 255.0f);
    EXPECT_EQ(image.at(2, 1, 1), 30.0f / 255.0f);
}

TEST(Pcx, DamagedFilesAreRefused) {
    Bytes bytes = paletted();
    bytes[bytes.size() - 769] = 13;
    EXPECT_NE(refusal(bytes).find("palette"), std::string::npos);
    bytes = paletted();
    bytes[3] = 4;
    EXPECT_NE(refusal(bytes).find("1 planes of 4 bits"), std::string::npos);
    bytes = paletted();
    bytes[66] = 2;
    EXPECT_NE(refusal(bytes).find("lines of 2 bytes"), std::string::npos);
    bytes = paletted();
    bytes[8] = bytes[9] = bytes[10] = bytes[11] = 0xff;
    EXPECT_NE(refusal(bytes).find("65536 x 65536"), std::string::npos);
    // A large picture that the data cannot fill is told before any memory is taken for it.
    bytes = paletted();
    bytes[9] = bytes[11] = 0x3f;
    bytes[67] = 0x40;
    EXPECT_NE(refusal(bytes).find("it ends before its"), std::string::npos);
    bytes = head(3, 2, 3, 4);
    append(bytes, {0xc2, 1, 0xc1});
    EXPECT_NE(refusal(bytes).find("it ends in line 1"), std::string::npos);
}

TEST(Pcx, EveryTruncationIsAnErrorOrAPicture) {
    const Bytes whole = paletted();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THROW(decodeImage({whole.data(), size}, "x.pcx"), Error) << size;
}

}  // namespace
}  // namespace ombrage
