// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/trace.h"
#include "render/renderer_impl.h"
#include "render/standard_views.h"

namespace ombrage {

namespace {

/// What a pipeline that changes nothing leaves: visibility 1.
Image allOpen(const GBuffer& gbuffer) {
    Image image = Image::grey(gbuffer.layout.width, gbuffer.layout.height, "visibility");
    std::fill(image.plane(0).begin(), image.plane(0).end(), 1.0f);
    return image;
}

}  // namespace

void Renderer::Impl::readBackImages(RenderResult& result, const FrameTargets& produced) {
    for (const auto& [index, texture] : produced.visibility)
        result.visibility[index] = texture ? readColor(*texture, {"visibility"}, ColorSpace::Data) : allOpen(*gbuffer);
    result.ao = produced.ao ? readColor(*produced.ao, {"visibility"}, ColorSpace::Data) : allOpen(*gbuffer);
    readIds(*gbuffer, gpuScene->flat(), result.instance, result.triangle);
}

void Renderer::Impl::readBack(RenderResult& result, const FrameContext& frame, const FrameTargets& produced,
                              bool images) {
    const TraceScope trace("read back");
    result.picture = readColor(*produced.color, {"R", "G", "B"}, ColorSpace::Linear);
    if (!images) return;
    readBackImages(result, produced);

    auto& shown = recorder.shown;
    const auto offer = [&](const std::string& name, auto&& make) {
        if (recorder.wantsAll || recorder.wanted.count(name) > 0) shown[name] = make();
    };
    offer("final", [&] { return ShownImage{result.picture, result.picture}; });
    offer("visibility", [&] {
        const Image& first = result.visibility.empty() ? *result.ao : result.visibility.begin()->second;
        return ShownImage{first, first};
    });
    for (const auto& [index, image] : result.visibility)
        if (index != result.visibility.begin()->first)
            offer("visibility@" + frame.scene->lights[std::size_t(index)].name, [&shownImage = image] {
                return ShownImage{shownImage, shownImage};
            });
    offer("ao", [&] { return ShownImage{*result.ao, *result.ao}; });
    offer("indirect", [&] {
        if (produced.indirect) return showTexture(*produced.indirect, ShowAs::Color);
        const Image black = Image::rgb(gbuffer->layout.width, gbuffer->layout.height);
        return ShownImage{black, black};
    });
    for (const PassInfo& view : standardGBufferViews())
        offer(view.name, [&] { return showGBuffer(view.name, *gbuffer, frame.view, gpuScene->flat()); });
    for (auto& [name, image] : shown) {
        result.shown[name] = std::move(image.display);
        result.shownRaw[name] = std::move(image.raw);
    }
}

}  // namespace ombrage
