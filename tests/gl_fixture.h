// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "gl/context.h"

namespace ombrage {

/// A test with OpenGL: one headless debug context per test program, and any message of it fails the test that caused
/// it. OMBRAGE_DEVICE chooses the device as `--device` does.
class GlTest : public testing::Test {
protected:
    /// The context is current before the members of a derived fixture are made.
    GlTest() { context().makeCurrent(); }

    static gl::Context& context() {
        static const std::unique_ptr<gl::Context> shared = make();
        return *shared;
    }

    void SetUp() override { context().takeDebugMessages(); }

    void TearDown() override {
        context().makeCurrent();
        for (const std::string& message : context().takeDebugMessages()) ADD_FAILURE() << "OpenGL says " << message;
    }

private:
    static std::unique_ptr<gl::Context> make() {
        const char* device = std::getenv("OMBRAGE_DEVICE");
        gl::ContextOptions options;
        options.device = device != nullptr ? device : "";
        options.debug = true;
        return gl::Context::createHeadless(options);
    }
};

}  // namespace ombrage
