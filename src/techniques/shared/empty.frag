// SPDX-License-Identifier: MIT
// For passes that write depth or stencil alone.
void main() {}
