// A file's bytes to its document.
#include <fmt/format.h>

#include "input/svg/walk.hpp"

namespace strandline::svg {

namespace {

/// Inkscape counted 90 px to the inch until 0.92 (released in January 2017).
std::optional<std::string_view> old_inkscape(pugi::xml_node root) {
    const std::string_view version = trimmed(root.attribute("inkscape:version").value());
    constexpr double first_with_96 = 0.92;
    Scanner scanner{version};
    const auto number = take_number(scanner);
    if (number.state != ValueState::good || number.value >= first_with_96) return std::nullopt;
    return version.substr(0, version.find(' '));
}

double dpi_of(pugi::xml_node root, double wanted) {
    constexpr double of_css = 96, of_old_inkscape = 90;
    return wanted > 0 ? wanted : old_inkscape(root) ? of_old_inkscape : of_css;
}

std::optional<Warning> size_doubt(const Walk& walk, pugi::xml_node root) {
    if (walk.options.dpi > 0 || !walk.frame.size_in_px) return std::nullopt;
    const auto place = place_of(walk.markup, root);
    if (const auto version = old_inkscape(root))
        return Warning{place,
                       fmt::format("written by Inkscape {}: its px are taken as 90 to the inch (--dpi 96 "
                                   "takes them as browsers do)",
                                   clipped(*version))};
    if (walk.markup.by_illustrator)
        return Warning{
            place,
            "written by Illustrator, whose px may be 72 to the inch: they are taken as 96 (--dpi 72 "
            "takes them as its own)"};
    return std::nullopt;
}

/// Style sheets stand anywhere and hold for all of the file.
void survey(Walk& walk) {
    for (const auto node : walk.markup.tree.children())
        if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet")
            note(walk.notes, "a style sheet in another file: not followed",
                 walk.markup.tree.document_element());
    for (auto node = walk.markup.tree.document_element(); node; node = next_in_document(node)) {
        const auto name = local_name(node.name());
        if (name == "style") add_style_element(walk.sheet, node, walk.notes);
        if (name == "g" && !walk.has_layers)
            walk.has_layers = std::string_view(node.attribute("inkscape:groupmode").value()) == "layer";
    }
}

}  // namespace

Outcome<Document> read(std::string_view text, const ReadOptions& options, const Progress& progress) {
    const auto markup = parse_markup(text, options.limits);
    if (!markup) return tl::unexpected(markup.error());
    const auto root = (*markup)->tree.document_element();
    if (local_name(root.name()) != "svg")
        return fail(place_of(**markup, root), "the outermost element is not <svg>", "give an SVG file");
    if (!(options.dpi >= 0) || options.dpi > largest_number)
        return fail("--dpi", fmt::format("{:g} px to the inch", options.dpi), "give 96, 90 or 72");
    Walk walk{.markup = **markup,
              .options = options,
              .progress = progress,
              .notes = {**markup, {}},
              .references = {**markup, false, {}}};
    walk.sheet.most_steps = options.limits.steps;
    auto frame = root_frame(root, dpi_of(root, options.dpi), walk.notes);
    if (!frame) return tl::unexpected(frame.error());
    walk.frame = *frame;
    survey(walk);

    Surroundings around;
    around.viewport = frame->viewport;
    around.percent_known = frame->percent_known;
    around.map = frame->map;
    const std::string_view name = root.name();
    if (const auto colon = name.rfind(':'); colon != std::string_view::npos)
        around.svg_prefix = name.substr(0, colon);
    walk_element(walk, root, around, 1);
    if (walk.error) return tl::unexpected(*walk.error);

    auto& document = walk.document;
    document.dpi = frame->viewport.dpi;
    document.size_metres = frame->size_metres;
    document.size_doubt = size_doubt(walk, root);
    if (frame->view) {
        document.view = *frame->view;
    } else {
        for (const auto& shape : document.shapes)
            for (const auto& path : shape.subpaths) document.view = united(document.view, bounds(path));
    }
    if (const auto sizes = root.attribute("rake_sizes")) {
        auto values = number_list(sizes.value(), place_of(**markup, root), "rake_sizes");
        if (values)
            document.rake_sizes = std::move(*values);
        else
            note(walk.notes, "rake_sizes is not a list of numbers: passed over", root, sizes.value());
    }
    document.warnings = as_warnings(walk.notes);
    progress.report("reading the drawing", 1);
    return std::move(document);
}

}  // namespace strandline::svg
