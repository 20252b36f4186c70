// SPDX-License-Identifier: MIT
#include <ombrage/image.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>
#include <ombrage/error.h>
#include <stb/stb_image_write.h>

namespace ombrage {
namespace {

namespace fs = std::filesystem;

class ImageFiles : public testing::Test {
protected:
    ImageFiles() {
        m_folder = fs::path(testing::TempDir()) / ("ombrage-" + std::to_string(std::uintptr_t(this)) + "-" +
                                                   testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(m_folder);
    }
    ~ImageFiles() override { fs::remove_all(m_folder); }

    fs::path file(const std::string& name) const { return m_folder / name; }

private:
    fs::path m_folder;
};

const float kInfinity = std::numeric_limits<float>::infinity();
const float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Smooth, without symmetry: flipped or swapped planes show.
Image ramp(int width, int height, const std::vector<std::string>& planes, ColorSpace space) {
    Image image(width, height, planes, space);
    for (int p = 0; p < image.planeCount(); ++p)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) image.at(p, x, y) = float(x + 2 * y + p) / float(width + 2 * height + 3);
    return image;
}

double largestDifference(const Image& a, const Image& b) {
    double largest = 0;
    for (int p = 0; p < a.planeCount(); ++p)
        for (std::size_t i = 0; i < a.pixelCount(); ++i)
            largest = std::max(largest, std::abs(double(a.plane(p)[i]) - double(b.plane(p)[i])));
    return largest;
}

/// The error that reading this file gives; it must be an input error that names the file.
std::string readError(const fs::path& path) {
    try {
        readImage(path);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Input) << e.what();
        EXPECT_NE(e.where().find(path.string()), std::string::npos) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "no error for " << path;
    return {};
}

std::vector<char> bytesOf(const fs::path& path) {
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
}

void writeBytes(const fs::path& path, const std::vector<char>& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

TEST_F(ImageFiles, PngKeepsEveryPlaneToHalfAStep) {
    const std::vector<std::vector<std::string>> kinds = {{"Y"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    for (const auto& planes : kinds) {
        const Image written = ramp(7, 5, planes, ColorSpace::Srgb);
        writeImage(file("a.png"), written);
        const Image read = readImage(file("a.png"));
        EXPECT_EQ(read.planeNames(), planes);
        EXPECT_EQ(read.width(), 7);
        EXPECT_EQ(read.height(), 5);
        EXPECT_EQ(read.colorSpace(), ColorSpace::Srgb);
        // Rounded to the nearest of 255 steps; the rest is float noise.
        EXPECT_LE(largestDifference(written, read), 0.5 / 255 + 1e-6);
    }
}

TEST_F(ImageFiles, PngEncodesLinearLightOnceAndLeavesDataAlone) {
    for (const auto& [space, expected] : std::initializer_list<std::pair<ColorSpace, float>>{
             {ColorSpace::Linear, 0.4613561f}, {ColorSpace::Srgb, 0.18f}, {ColorSpace::Data, 0.18f}}) {
        Image image = Image::rgb(1, 1, space);
        for (int p = 0; p < 3; ++p) image.at(p, 0, 0) = 0.18f;
        writeImage(file("a.png"), image);
        EXPECT_NEAR(readImage(file("a.png")).at(1, 0, 0), expected, 0.5f / 255 + 1e-6f);
    }
}

TEST_F(ImageFiles, PngSaturatesAndShowsNaNAsBlack) {
    Image image = Image::grey(5, 1);
    const float values[5] = {kNaN, kInfinity, -kInfinity, 2.0f, -1.0f};
    std::copy(values, values + 5, image.plane(0).begin());
    writeImage(file("a.png"), image);
    const Image read = readImage(file("a.png"));
    const float expected[5] = {0, 1, 0, 1, 0};
    EXPECT_TRUE(std::equal(expected, expected + 5, read.plane(0).begin()));
}

TEST_F(ImageFiles, EncodedPngIsTheFile) {
    const Image image = ramp(7, 5, {"R", "G", "B"}, ColorSpace::Linear);
    writeImage(file("a.png"), image);
    const std::vector<unsigned char> encoded = encodePng(image);
    const std::vector<char> written = bytesOf(file("a.png"));
    EXPECT_TRUE(std::equal(written.begin(), written.end(), encoded.begin(), encoded.end(),
                           [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; }));
    EXPECT_EQ(decodeImage(encoded, "memory"), readImage(file("a.png")));
}

TEST_F(ImageFiles, JpegKeepsSmoothPictures) {
    for (const auto& planes : std::vector<std::vector<std::string>>{{"Y"}, {"R", "G", "B"}}) {
        const Image written = ramp(32, 24, planes, ColorSpace::Srgb);
        writeImage(file("a.jpg"), written);
        const Image read = readImage(file("a.jpg"));
        EXPECT_EQ(read.colorSpace(), ColorSpace::Srgb);
        ASSERT_EQ(read.pixelCount(), written.pixelCount());
        // Quality 92 quantises the steepest coefficients of a ramp by about 3 of 255; a grey JPEG may come back as RGB.
        EXPECT_LE(
            largestDifference(written.planeCount() == 1 ? written : read, written.planeCount() == 1 ? read : written),
            0.02);
    }
}

TEST_F(ImageFiles, ExrKeepsEveryBitOfEveryPlane) {
    Image image(3, 2, {"R", "G", "B", "A", "depth.Z", "id"}, ColorSpace::Linear);
    for (int p = 0; p < image.planeCount(); ++p)
        for (int i = 0; i < 6; ++i) image.plane(p)[std::size_t(i)] = float(p * 6 + i) / 7 - 2;
    image.at(4, 0, 0) = kInfinity;
    image.at(4, 1, 0) = -kInfinity;
    image.at(5, 2, 1) = 16777215.0f;
    writeImage(file("a.exr"), image);
    EXPECT_EQ(readImage(file("a.exr")), image);
}

TEST_F(ImageFiles, ExrKeepsNaN) {
    Image image = Image::grey(2, 1, "visibility");
    image.at(0, 0, 0) = kNaN;
    image.at(0, 1, 0) = 0.5f;
    writeImage(file("a.exr"), image);
    const Image read = readImage(file("a.exr"));
    EXPECT_TRUE(std::isnan(read.plane("visibility")[0]));
    EXPECT_EQ(read.plane("visibility")[1], 0.5f);
    EXPECT_EQ(read.colorSpace(), ColorSpace::Data) << "no R, G and B: numbers, not light";
}

TEST_F(ImageFiles, ExrIsNeverEncoded) {
    Image image = Image::rgb(1, 1, ColorSpace::Linear);
    image.at(0, 0, 0) = 0.18f;
    writeImage(file("a.exr"), image);
    EXPECT_EQ(readImage(file("a.exr")).at(0, 0, 0), 0.18f);
}

TEST_F(ImageFiles, TheContentTellsTheKind) {
    writeImage(file("a.exr"), ramp(4, 4, {"R", "G", "B"}, ColorSpace::Linear));
    fs::rename(file("a.exr"), file("a.png"));
    EXPECT_EQ(readImage(file("a.png")).colorSpace(), ColorSpace::Linear);
}

TEST_F(ImageFiles, PngAndJpegRefuseWhatTheyCannotHold) {
    for (const char* name : {"a.png", "a.jpg"}) {
        EXPECT_THROW(writeImage(file(name), Image(2, 2, {"a", "b"})), Error) << name;
        EXPECT_THROW(writeImage(file(name), Image(2, 2, {"a", "b", "c", "d", "e"})), Error) << name;
        EXPECT_THROW(writeImage(file(name), Image(0, 0, {"Y"})), Error) << name;
    }
    EXPECT_THROW(writeImage(file("a.jpg"), ramp(2, 2, {"R", "G", "B", "A"}, ColorSpace::Srgb)), Error)
        << "alpha is not lost";
}

TEST_F(ImageFiles, WritingMakesFoldersAndTakesAnyCaseOfTheExtension) {
    writeImage(file("deep/er/a.PNG"), ramp(2, 2, {"Y"}, ColorSpace::Data));
    EXPECT_EQ(readImage(file("deep/er/a.PNG")).width(), 2);
}

TEST_F(ImageFiles, WritingSaysWhatIsWrongAndWhere) {
    try {
        writeImage(file("a.gif"), ramp(2, 2, {"Y"}, ColorSpace::Data));
        FAIL() << "no error";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::Usage);
        EXPECT_NE(std::string(e.what()).find(".gif"), std::string::npos);
        EXPECT_NE(e.hint().find(".png"), std::string::npos);
    }
    // A folder where the file should go: neither kind can be written.
    for (const char* name : {"taken.png", "taken.exr"}) {
        fs::create_directories(file(name));
        try {
            writeImage(file(name), ramp(2, 2, {"Y"}, ColorSpace::Data));
            FAIL() << "no error";
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::Environment);
            EXPECT_NE(e.where().find(name), std::string::npos);
        }
    }
}

TEST_F(ImageFiles, ReadingNamesTheFile) {
    readError(file("missing.png"));
    writeBytes(file("empty.png"), {});
    readError(file("empty.png"));
    writeBytes(file("text.png"), {'h', 'e', 'l', 'l', 'o', ' ', 'w', 'o', 'r', 'l', 'd', '\n'});
    readError(file("text.png"));
    fs::create_directories(file("folder.png"));
    readError(file("folder.png"));
}

void appendTo(void* bytes, void* data, int size) {
    auto& all = *static_cast<std::vector<char>*>(bytes);
    all.insert(all.end(), static_cast<char*>(data), static_cast<char*>(data) + size);
}

TEST_F(ImageFiles, TruncatedFilesAreErrorsOfEveryKind) {
    const Image image = ramp(40, 30, {"R", "G", "B"}, ColorSpace::Srgb);
    for (const char* name : {"a.png", "a.jpg", "a.exr"}) writeImage(file(name), image);
    std::vector<unsigned char> pixels(40 * 30 * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = (unsigned char)(i * 37);
    for (const auto& [name, rle] : std::initializer_list<std::pair<const char*, int>>{{"raw.tga", 0}, {"rle.tga", 1}}) {
        std::vector<char> bytes;
        stbi_write_tga_with_rle = rle;
        stbi_write_tga_to_func(&appendTo, &bytes, 40, 30, 3, pixels.data());
        writeBytes(file(name), bytes);
    }
    std::vector<char> bmp;
    stbi_write_bmp_to_func(&appendTo, &bmp, 40, 30, 3, pixels.data());
    writeBytes(file("a.bmp"), bmp);

    for (const char* name : {"a.png", "a.jpg", "a.exr", "raw.tga", "rle.tga", "a.bmp"}) {
        EXPECT_NO_THROW(readImage(file(name))) << name;
        const std::vector<char> whole = bytesOf(file(name));
        // Cut inside the header, in the middle, and so that only the last 40 bytes are missing (a PNG's last 12 are an
        // empty chunk, TGA files end in a footer of 26 that some writers leave out).
        for (std::size_t length : {std::size_t(10), whole.size() / 3, whole.size() / 2, whole.size() - 40}) {
            const fs::path cut = file("cut" + fs::path(name).extension().string());
            writeBytes(cut, {whole.begin(), whole.begin() + std::ptrdiff_t(length)});
            EXPECT_THROW(readImage(cut), Error) << name << " cut to " << length << " of " << whole.size();
        }
    }
}

}  // namespace
}  // namespace ombrage
