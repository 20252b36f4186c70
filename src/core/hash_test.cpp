// SPDX-License-Identifier: MIT
#include "core/hash.h"

#include <bit>
#include <set>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

std::string hexOf(const std::string& bytes) {
    Hasher hasher;
    hasher.bytes(bytes.data(), bytes.size());
    return hasher.hex();
}

TEST(MixedBits, IsSplitmixsFinaliser) {
    // The first two numbers of splitmix64 from 0, as its authors' program prints them.
    EXPECT_EQ(mixedBits(0x9e3779b97f4a7c15ull), 0xe220a8397b1dcdafull);
    EXPECT_EQ(mixedBits(2 * 0x9e3779b97f4a7c15ull), 0x6e789e6aa1b965f4ull);
    EXPECT_EQ(mixedBits(0), 0u);
}

TEST(Hasher, StaysWhatItIs) {
    // Records of earlier versions hold these: scenes must keep their hashes. Worked out apart from the code, in Python,
    // from the definition: FNV-1a's offset and prime, x ^= x >> 32 after each word, the tail bytewise, splitmix64's
    // finaliser.
    EXPECT_EQ(hexOf(""), "f52a15e9a9b5e89b");
    EXPECT_EQ(hexOf("a"), "5f29c2aadd9b8527");
    EXPECT_EQ(hexOf("shadows!"), "6bec1cb2d84a6806");
    EXPECT_EQ(hexOf("shadows and occlusion"), "585f66c9e98f600c");
}

TEST(Hasher, EveryBitOfEveryByteCounts) {
    // 21 bytes: two words and a tail. All 168 one-bit changes give different hashes, and each flips about half of the
    // 64 bits: fewer than 10 has probability 2e-9 per change for a good hash.
    const std::string text = "shadows and occlusion";
    std::set<std::string> seen{hexOf(text)};
    Hasher original;
    original.bytes(text.data(), text.size());
    for (std::size_t i = 0; i < text.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            std::string changed = text;
            changed[i] = char(changed[i] ^ (1 << bit));
            Hasher hasher;
            hasher.bytes(changed.data(), changed.size());
            EXPECT_TRUE(seen.insert(hasher.hex()).second) << i << " " << bit;
            EXPECT_GE(std::popcount(hasher.digest() ^ original.digest()), 10) << i << " " << bit;
        }
}

TEST(Hasher, LengthAndOrderCount) {
    EXPECT_NE(hexOf(std::string(1, '\0')), hexOf(std::string(2, '\0')));
    EXPECT_NE(hexOf(std::string(8, '\0')), hexOf(std::string(16, '\0')));
    EXPECT_NE(hexOf("aaaaaaaabbbbbbbb"), hexOf("bbbbbbbbaaaaaaaa"));
    Hasher one, two;
    one.text("ab"), one.text("c");
    two.text("a"), two.text("bc");
    EXPECT_NE(one.digest(), two.digest()) << "texts do not run into one another";
}

TEST(Hasher, ValuesAndArraysAreTheirBytes) {
    Hasher values, bytes;
    const std::uint32_t number = 0x01020304;
    values.value(number);
    bytes.bytes(&number, 4);
    EXPECT_EQ(values.digest(), bytes.digest());

    Hasher array, empty;
    array.array(std::vector<float>{0.0f});
    empty.array(std::vector<float>{});
    EXPECT_NE(array.digest(), empty.digest());
}

TEST(Hasher, HexHasSixteenDigits) {
    EXPECT_EQ(hexOf("").size(), 16u);
    EXPECT_EQ(hexOf("x").find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace ombrage
