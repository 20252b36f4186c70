// SPDX-License-Identifier: MIT
// PER_PASS declares what is the same for every pixel of a full-screen pass: the vertex stage writes it, the fragments read it
// flat. Some drivers fetch a uniform for every pixel by itself (llvmpipe: some 26 instructions a number), a flat input once.
// FULLSCREEN comes from FrameContext::program; other programs have no PER_PASS and read the blocks themselves.
#ifdef FULLSCREEN
#ifdef FULLSCREEN_VERTEX
#define PER_PASS flat out
#else
#define PER_PASS flat in
#endif
#endif
