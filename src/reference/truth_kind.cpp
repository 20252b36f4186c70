// SPDX-License-Identifier: MIT
#include <ombrage/truth_kind.h>

#include <algorithm>

#include <ombrage/error.h>

#include "core/strings.h"

namespace ombrage {
namespace {

constexpr Quantity kQuantities[] = {Quantity::Shadow, Quantity::Ao, Quantity::Indirect, Quantity::Picture};
constexpr TruthKind kKinds[] = {TruthKind::Shadow, TruthKind::Self,      TruthKind::T1,  TruthKind::T2,
                                TruthKind::T3,     TruthKind::T4,        TruthKind::T5,  TruthKind::T5Ball,
                                TruthKind::Own,    TruthKind::Displaced, TruthKind::Area};

}  // namespace

const char* quantityName(Quantity quantity) {
    switch (quantity) {
        case Quantity::Shadow:
            return "shadow";
        case Quantity::Ao:
            return "ao";
        case Quantity::Indirect:
            return "indirect";
        case Quantity::Picture:
            return "picture";
    }
    return "";
}

Quantity quantityFromName(const std::string& name) {
    std::vector<std::string> names;
    for (const Quantity quantity : kQuantities) {
        if (name == quantityName(quantity)) return quantity;
        names.emplace_back(quantityName(quantity));
    }
    throw unknownName("quantity", name, names);
}

const char* truthKindName(TruthKind kind) {
    switch (kind) {
        case TruthKind::Shadow:
            return "shadow";
        case TruthKind::Self:
            return "self";
        case TruthKind::T1:
            return "T1";
        case TruthKind::T2:
            return "T2";
        case TruthKind::T3:
            return "T3";
        case TruthKind::T4:
            return "T4";
        case TruthKind::T5:
            return "T5";
        case TruthKind::T5Ball:
            return "T5-ball";
        case TruthKind::Own:
            return "own";
        case TruthKind::Displaced:
            return "displaced";
        case TruthKind::Area:
            return "area";
    }
    return "";
}

const std::vector<TruthKind>& truthKindsOf(Quantity quantity) {
    static const std::vector<TruthKind> shadow{TruthKind::Shadow, TruthKind::Self, TruthKind::Area};
    static const std::vector<TruthKind> ao{TruthKind::T1,  TruthKind::T2,        TruthKind::T3,
                                           TruthKind::T4,  TruthKind::T5,        TruthKind::T5Ball,
                                           TruthKind::Own, TruthKind::Displaced, TruthKind::Area};
    // Neither has a question of its own: the light that arrives, at the pixel's centre or over the pixel.
    static const std::vector<TruthKind> indirect{}, picture{TruthKind::Area};
    switch (quantity) {
        case Quantity::Shadow:
            return shadow;
        case Quantity::Ao:
            return ao;
        case Quantity::Indirect:
            return indirect;
        case Quantity::Picture:
            break;
    }
    return picture;
}

TruthKind truthKindFromName(const std::string& name) {
    std::vector<std::string> names;
    for (const TruthKind kind : kKinds) {
        if (name == truthKindName(kind)) return kind;
        names.emplace_back(truthKindName(kind));
    }
    throw unknownName("truth", name, names);
}

TruthKind truthKindFromName(const std::string& name, Quantity quantity) {
    const TruthKind kind = truthKindFromName(name);
    const std::vector<TruthKind>& fitting = truthKindsOf(quantity);
    if (std::find(fitting.begin(), fitting.end(), kind) != fitting.end()) return kind;
    std::vector<std::string> names;
    for (const TruthKind other : fitting) names.emplace_back(truthKindName(other));
    throw Error(ErrorCode::Usage, "the truth '" + name + "' does not fit the quantity " + quantityName(quantity),
                names.empty() ? std::string("leave --truth out") : "it has " + join(names, ", "));
}

}  // namespace ombrage
