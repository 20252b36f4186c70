// SPDX-License-Identifier: MIT
// Stands in for ShadowLookup::perPass.
void passLookup() {}
