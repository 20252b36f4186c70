// SPDX-License-Identifier: MIT
// Stands in for what FrameContext::program makes of a technique's parameters.
void passParams() {}
