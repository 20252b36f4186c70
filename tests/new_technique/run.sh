#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: run.sh SOURCE_DIR BINARY_DIR CMAKE GENERATOR BUILD_TYPE
# Adding a technique adds a folder and edits no list: in a copy of the sources, tools/new_technique makes two techniques, one line
# each declares and uses another parameter, and everything that lists, documents, tests or renders techniques knows them.
# With ccache the copy takes nearly all objects from the build that it is a copy of; without it a debug build is made.
set -euo pipefail
source_dir="$(cd "$1" && pwd)"
binary_dir="$(cd "$2" && pwd)"
cmake="$3" generator="$4" build_type="$5"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
copy="$work/ombrage"
fail() { echo "FAILED: $*" >&2; exit 1; }

# The sources without what was built; the build folder lies where it does in the original, so that relative paths agree.
mkdir "$copy"
relative_build="build/copy"
case "$binary_dir" in "$source_dir"/*) relative_build="${binary_dir#"$source_dir"/}" ;; esac
tar -C "$source_dir" --exclude=./.git --exclude=./build --exclude=./out --exclude="./$relative_build" -cf - . | tar -C "$copy" -xf -
cp -r "$copy" "$work/before"

for id in shadow/zz-dummy ao/zz-dummy; do
  "$copy/tools/new_technique" "$id" >/dev/null
  file="$copy/src/techniques/$id/zz_dummy"
  sed -i -e 's|^    float strength = 1.0f;|&\n    float gain = 1.0f;|' \
         -e 's|return fields(|&field(\&P::gain, "gain").range(0, 1).help("A second parameter."),\n                      |' "$file.cpp"
  sed -i -e 's|params.strength|params.strength * params.gain|' "$file.frag"
  grep -q '"gain"' "$file.cpp" && grep -q 'params.gain' "$file.frag" || fail "$id: no place for another parameter"
done

# Nothing but the two folders is new or changed.
changed="$(LC_ALL=C diff -rq "$work/before" "$copy" || true)"
expected="Only in $copy/src/techniques/ao: zz-dummy
Only in $copy/src/techniques/shadow: zz-dummy"
[ "$changed" = "$expected" ] || fail "other files changed too: $changed"

command -v ccache >/dev/null || build_type=Debug
build="$copy/$relative_build"
"$cmake" -S "$copy" -B "$build" -G "$generator" -DCMAKE_BUILD_TYPE="$build_type" -DOMBRAGE_BUILD_TESTS=ON >"$work/log" 2>&1 ||
  { cat "$work/log"; fail "the copy does not configure"; }
started=$SECONDS
"$cmake" --build "$build" --parallel 2 --target ombrage_cli ombrage_technique_tests ombrage_docs >"$work/log" 2>&1 ||
  { tail -50 "$work/log"; fail "the copy does not build"; }
echo "built in $((SECONDS - started)) s"

program="$build/bin/ombrage"
for id in shadow/zz-dummy ao/zz-dummy; do
  grep -q "\"id\": \"$id\"" <<<"$("$program" list --json)" || fail "list --json does not know $id"
  params="$("$program" list params "$id")"
  for key in strength gain; do grep -q "^$key" <<<"$params" || fail "list params $id lacks $key: $params"; done
done

# Both parameters reach the shader: 0.5 times 0.5 is 0.25, and not 1.
render() { "$program" render gap --size 64x36 -o "$work/$1" "${@:2}" >"$work/log" 2>&1 || { cat "$work/log"; fail "render ${*:2}"; }; }
render product.png --shadow zz-dummy:strength=0.5,gain=0.5 --ao zz-dummy:gain=0.5
render value.png --shadow shadow/zz-dummy:strength=0.25 --ao ao/zz-dummy:strength=0.5
render whole.png --shadow zz-dummy --ao zz-dummy
"$program" diff "$work/product.png" "$work/value.png" --metric mae --fail-above 0 >/dev/null 2>&1 || fail "the parameters do not multiply"
! "$program" diff "$work/product.png" "$work/whole.png" --metric mae --fail-above 0.01 >/dev/null 2>&1 || fail "the parameters do nothing"
message="$("$program" render gap -o "$work/no.png" --shadow zz-dummy:gian=1 2>&1)" && fail "a wrong key was taken"
grep -q "did you mean 'gain'" <<<"$message" || fail "no suggestion: $message"

# The manual has their pages, with the rows of both parameters.
generator_program="$(find "$build" -name ombrage_docs -type f | head -1)"
"$generator_program" "$copy" "$work/docs" >"$work/log" 2>&1 || { cat "$work/log"; fail "the manual is not made"; }
for page in shadow-zz-dummy ao-zz-dummy; do
  grep -q '^| `strength` |' "$work/docs/techniques/$page.md" && grep -q '^| `gain` |' "$work/docs/techniques/$page.md" || fail "the manual lacks rows in $page.md"
done
grep -q 'shadow-zz-dummy.md' "$work/docs/techniques/README.md" || fail "the manual's index lacks the page"

# The tests that every technique passes take them up, and they pass.
tests="$(find "$build" -name ombrage_technique_tests -type f | head -1)"
"$tests" --gtest_filter='*zz_dummy*' >"$work/log" 2>&1 || { cat "$work/log"; fail "the technique tests fail"; }
grep -q 'zz_dummy' "$work/log" || fail "no test took the new techniques up"
echo "two techniques, two folders, no list"
