// SPDX-License-Identifier: MIT
#include <ombrage/error.h>

#include <gtest/gtest.h>

namespace ombrage {
namespace {

TEST(Error, SaysWhereWhatAndWhatToDo) {
    const Error e(ErrorCode::Input, "no such mesh", "name one", "a.json:3: /models/0");
    EXPECT_EQ(e.code(), ErrorCode::Input);
    EXPECT_EQ(e.message(), "no such mesh");
    EXPECT_EQ(e.hint(), "name one");
    EXPECT_EQ(e.where(), "a.json:3: /models/0");
    EXPECT_STREQ(e.what(), "a.json:3: /models/0: no such mesh (name one)");
}

TEST(Error, LeavesOutWhatIsEmpty) {
    EXPECT_STREQ(Error(ErrorCode::Usage, "wrong").what(), "wrong");
    EXPECT_STREQ(Error(ErrorCode::Usage, "wrong", "do right").what(), "wrong (do right)");
    EXPECT_STREQ(Error(ErrorCode::Usage, "wrong", "", "here").what(), "here: wrong");
}

TEST(Error, CodesAreTheExitCodesOfTheCommandLine) {
    EXPECT_EQ(int(ErrorCode::GateFailed), 1);
    EXPECT_EQ(int(ErrorCode::Usage), 2);
    EXPECT_EQ(int(ErrorCode::Input), 3);
    EXPECT_EQ(int(ErrorCode::Environment), 4);
    EXPECT_EQ(int(ErrorCode::Interrupted), 130);
}

TEST(NearestName, CountsInsertionsDeletionsChangesAndTranspositionsOnce) {
    // Names of 5 letters allow max(2, 5/3) = 2 edits.
    EXPECT_EQ(nearestName("slpoe", {"slope", "shape"}), "slope");    // 1 transposition
    EXPECT_EQ(nearestName("sloope", {"slope", "sloppy"}), "slope");  // 1 deletion
    EXPECT_EQ(nearestName("slop", {"slope", "soap"}), "slope");      // 1 insertion against 2 edits
    EXPECT_EQ(nearestName("sxyze", {"slope"}), "");                  // 3 changes are too many
    EXPECT_EQ(nearestName("sxype", {"slope"}), "slope");             // 2 are not
}

TEST(NearestName, AllowsAThirdOfALongName) {
    // 12 letters allow 4 edits.
    EXPECT_EQ(nearestName("abcdXXXXijkl", {"abcdefghijkl"}), "abcdefghijkl");
    EXPECT_EQ(nearestName("abcdXXXXXjkl", {"abcdefghijkl"}), "");
}

TEST(NearestName, IgnoresCaseAndTheFamilyOfAnId) {
    EXPECT_EQ(nearestName("MAP", {"shadow/map", "ao/none"}), "shadow/map");
    EXPECT_EQ(nearestName("shadwo/map", {"shadow/map", "shadow/none"}), "shadow/map");
    EXPECT_EQ(nearestName("anything", {}), "");
}

TEST(NearestName, TakesTheFirstOfEquals) {
    EXPECT_EQ(nearestName("ab", {"ax", "ay"}), "ax");
}

TEST(UnknownName, SuggestsTheNearestOrListsAll) {
    const Error near = unknownName("camera", "mian", {"main", "side"});
    EXPECT_EQ(near.code(), ErrorCode::Usage);
    EXPECT_EQ(near.message(), "unknown camera 'mian'");
    EXPECT_EQ(near.hint(), "did you mean 'main'?");
    EXPECT_EQ(unknownName("camera", "zzzzzz", {"main", "side"}).hint(), "there are: main, side");
    EXPECT_EQ(unknownName("camera", "zzzzzz", {}).hint(), "");
}

}  // namespace
}  // namespace ombrage
