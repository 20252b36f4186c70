// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include <epoxy/gl.h>

#include <thread>

#include <ombrage/error.h>

#include "gl/objects.h"
#include "gl_fixture.h"

namespace ombrage::gl {
namespace {

class ContextTest : public GlTest {};

Error failure(const ContextOptions& options) {
    try {
        Context::createHeadless(options);
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "a context came up on device " << options.device;
    return Error(ErrorCode::GateFailed, "");
}

TEST_F(ContextTest, SaysWhatItIs) {
    EXPECT_FALSE(context().isAdopted());
    EXPECT_FALSE(context().renderer().empty());
    EXPECT_FALSE(context().vendor().empty());
    EXPECT_EQ(context().version().rfind("4.", 0), 0u) << context().version();
    ASSERT_FALSE(context().trace().empty());
    EXPECT_NE(context().trace().back().find(context().renderer()), std::string::npos);
    EXPECT_GE(context().capabilities().maxSamples, 4);                   // the least that 4.5 allows
    EXPECT_GE(context().capabilities().maxTextureSize, 16384);           // the same
    EXPECT_GE(context().capabilities().maxShaderStorageBytes, 1 << 27);  // the same
}

TEST_F(ContextTest, SoftwareCanBeForced) {
    const auto software = Context::createHeadless({"software", false});
    EXPECT_TRUE(software->isSoftware());
    EXPECT_TRUE(software->warnings().empty());
}

TEST_F(ContextTest, UnknownDevicesAreErrors) {
    EXPECT_EQ(failure({"gpu", false}).code(), ErrorCode::Usage);
    EXPECT_EQ(failure({"-1", false}).code(), ErrorCode::Usage);
    const Error error = failure({"99", false});
    EXPECT_EQ(error.code(), ErrorCode::Environment);
    EXPECT_NE(error.message().find("99"), std::string::npos);
    EXPECT_FALSE(error.hint().empty());
}

TEST_F(ContextTest, SeveralContextsKeepTheirOwnObjects) {
    const auto second = Context::createHeadless({"software", true});
    Buffer mine(16, nullptr, "second");
    glUseProgram(0);
    glViewport(0, 0, 7, 7);
    context().makeCurrent();
    GLint viewport[4] = {};
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_NE(viewport[2], 7);
    second->makeCurrent();
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(viewport[2], 7);
    mine = Buffer();
    EXPECT_TRUE(second->takeDebugMessages().empty());
}

TEST_F(ContextTest, EndOfOneContextLeavesTheOthersAlive) {
    Context::createHeadless({"software", false});
    context().makeCurrent();
    const Buffer buffer(16, nullptr, "still alive");
    EXPECT_EQ(glIsBuffer(buffer.id()), GL_TRUE);
}

TEST_F(ContextTest, MessagesAreCollectedOnce) {
    glEnable(GL_TEXTURE_2D + 12345);
    const auto messages = context().takeDebugMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].rfind("error ", 0), 0u) << messages[0];
    EXPECT_TRUE(context().takeDebugMessages().empty());
    while (glGetError() != GL_NO_ERROR) continue;
}

TEST_F(ContextTest, AdoptsTheCurrentContext) {
    const auto adopted = Context::adoptCurrent();
    EXPECT_TRUE(adopted->isAdopted());
    EXPECT_EQ(adopted->renderer(), context().renderer());
    adopted->makeCurrent();
    EXPECT_TRUE(adopted->takeDebugMessages().empty());
}

TEST_F(ContextTest, ThreadWithoutContextCannotAdopt) {
    // A thread starts without a context; asking there must be an error, not the end of the process.
    bool refused = false;
    std::thread([&refused] {
        try {
            Context::adoptCurrent();
        } catch (const Error& error) {
            refused = error.code() == ErrorCode::Environment;
        }
    }).join();
    EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace ombrage::gl
