// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/shared/ao_kernel.h"

namespace ombrage::blocks {
namespace {

constexpr AoOffsets kOffsets[] = {AoOffsets::Screen, AoOffsets::Hemisphere};
constexpr AoDistribution kDistributions[] = {AoDistribution::Uniform, AoDistribution::Cosine,
                                             AoDistribution::Importance};

TEST(BlocksKernel, LiesInItsDomainWithWeightsOfMeanOne) {
    for (const AoOffsets offsets : kOffsets)
        for (const AoDistribution distribution : kDistributions)
            for (const int count : {16, 32, 64}) {
                const auto kernel = aoKernel(offsets, distribution, count);
                ASSERT_EQ(int(kernel.size()), count);
                double weights = 0;
                for (const glm::vec4& k : kernel) {
                    EXPECT_LE(glm::length(glm::vec3(k)), 1.0f + 1e-6f);
                    EXPECT_GE(k.z, 0.0f);
                    EXPECT_TRUE(offsets == AoOffsets::Hemisphere || k.z == 0.0f);
                    EXPECT_GT(k.w, 0.0f);
                    weights += double(k.w);
                }
                // The disk's importance weights have no finite variance at the rim: 16 strata lose up to a fifth.
                EXPECT_NEAR(weights / count, 1.0, 0.2);
            }
}

// Integrals with closed forms, by 4096 points. Strata leave errors far under 0.01; a wrong density misses by 0.05 and
// more.
double meanOf(AoOffsets offsets, AoDistribution distribution, double (*f)(const glm::dvec3&)) {
    double sum = 0;
    constexpr int kCount = 4096;
    for (const glm::vec4& k : aoKernel(offsets, distribution, kCount)) sum += double(k.w) * f(glm::dvec3(k));
    return sum / kCount;
}

double falloff(const glm::dvec3& p) {
    return 1 - glm::dot(p, p);
}

double height(const glm::dvec3& p) {
    return p.z;
}

TEST(BlocksKernel, EvenAndImportanceKernelsHaveOneIntegral) {
    for (const AoDistribution distribution : {AoDistribution::Uniform, AoDistribution::Importance}) {
        // Disk: the mean of 1 - rho^2 is 1/2. Half ball: that of 1 - t^2 is 1 - 3/5, and of z is 3/8.
        EXPECT_NEAR(meanOf(AoOffsets::Screen, distribution, falloff), 0.5, 0.01);
        EXPECT_NEAR(meanOf(AoOffsets::Hemisphere, distribution, falloff), 0.4, 0.01);
        EXPECT_NEAR(meanOf(AoOffsets::Hemisphere, distribution, height), 0.375, 0.01);
    }
}

TEST(BlocksKernel, TheDisksCosineKernelIsTheShadowOfTheBalls) {
    // Mean of rho^2: lengths of density 2 t have a mean square of 1/2, cosine-weighted directions a mean sin^2 of 1/2.
    const auto across2 = [](const glm::dvec3& p) { return p.x * p.x + p.y * p.y; };
    EXPECT_NEAR(meanOf(AoOffsets::Hemisphere, AoDistribution::Cosine, across2), 0.25, 0.005);
    EXPECT_NEAR(meanOf(AoOffsets::Screen, AoDistribution::Cosine, across2), 0.25, 0.005);
}

}  // namespace
}  // namespace ombrage::blocks
