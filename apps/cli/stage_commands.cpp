// The command line of single stages: what can be written, not what is done.
#include "stage_commands.hpp"

#include <CLI/CLI.hpp>

namespace strandline::cli {

void add_stages(CLI::App& app, TourArguments& t, FillArguments& f, ConnectArguments& c, ConvertArguments& v,
                const Common& common, std::function<int()>& chosen) {
    const auto in_out = [](CLI::App* command, std::string& input, std::string& output, const char* what) {
        command->add_option("input", input, what)->required();
        command->add_option("-o,--output", output, "file, or - for stdout")->capture_default_str();
    };
    CLI::App* tour =
        app.add_subcommand("tour", "one stage alone: order and entries of a tour instance (JSON)");
    in_out(tour, t.input, t.output, "instance (docs/stage-formats.md), or -");
    tour->add_option("--moves", t.moves, "budget of the search; 0: from the size")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    tour->add_option("--time-limit", t.time_limit,
                     "stop after this CPU time (10s); the answer may differ from run to run");
    tour->add_option("--method", t.method,
                     "best; exact: the optimum or an error; nearest, file: without a search, to compare with")
        ->check(CLI::IsMember({"best", "exact", "nearest", "file"}))
        ->capture_default_str();
    tour->add_option("--order", t.order, "grouped: neighbouring elements are finished together")
        ->check(CLI::IsMember({"any", "grouped"}))
        ->capture_default_str();
    tour->add_option("--entries", t.entries,
                     "edges: along the order found, closed elements are entered anywhere on their edges")
        ->check(CLI::IsMember({"vertices", "edges"}))
        ->capture_default_str();
    tour->add_option("--threads", t.threads, "so many searches at once; the best is taken")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    tour->add_option("--write-tsplib", t.write_tsplib,
                     "write the problem for another solver (TSPLIB) and do nothing else");
    tour->add_option("--read-tour", t.read_tour, "instead of searching: the tour that such a solver wrote");
    tour->add_option("--seed", t.seed, "of the search")->check(CLI::NonNegativeNumber)->capture_default_str();
    tour->footer("Example:\n  strandline tour instance.json -o solution.json --time-limit 5s");
    tour->callback([&] { chosen = [&] { return cli::tour(t, common); }; });

    CLI::App* fill = app.add_subcommand("fill", "one stage alone: the strokes that rake a polygon (JSON)");
    in_out(fill, f.input, f.output, "polygon (docs/stage-formats.md), or -");
    fill->add_option("--width", f.width, "rake width; overrides the file's");
    fill->add_option("--style", f.style, "rings, spiral or zigzag")->capture_default_str();
    fill->add_option("--join", f.join,
                     "rings: how one leads on to the next: half-step, nearest, alternating or longest-edge")
        ->capture_default_str();
    fill->add_option("--inset", f.inset,
                     "rings, spiral: how they follow from the outline: offset (Euclidean) or skeleton")
        ->capture_default_str();
    fill->add_option("--shift", f.shift, "spiral, rake widths: the stretch of a turn that shifts outwards")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    fill->add_option("--spacing", f.spacing, "between neighbouring passes");
    fill->add_option("--direction", f.direction, "zigzag: of its lines; else what wastes least");
    fill->add_option("--partition", f.partition,
                     "zigzag: how an area is parted: none, monotone, optimal-convex or fitted")
        ->check(CLI::IsMember({"none", "monotone", "optimal-convex", "fitted"}))
        ->capture_default_str();
    fill->add_option("--cuts", f.cuts, "zigzag: lines that part areas first: \"0,2 4,2; 1,0 1,5\"");
    fill->add_option("--segments", f.segments,
                     "zigzag: directions and styles of segments, each by a point in it: \"2,3 "
                     "direction=30deg; 5,1 style=rings\"");
    fill->add_flag("--one-stroke", f.one_stroke, "the rake does not lift inside the area, as planned");
    fill->add_option("--pins", f.pins, "the rake has this many pins that lift; strokes get masks")
        ->check(CLI::Range(1, 32));
    fill->add_option("--narrow", f.narrow,
                     "what is narrower than the rake: single-pass (along its middle) or warn (left bare)")
        ->capture_default_str();
    fill->add_option("--vehicle", f.vehicle, "free (turns on the spot), or a robot")->capture_default_str();
    fill->footer("Example:\n  strandline fill letter.json --width 0.42 --style zigzag -o strokes.json");
    fill->callback([&] { chosen = [&] { return cli::fill(f, common); }; });

    CLI::App* connect = app.add_subcommand("connect", "one stage alone: curves between poses (JSON lines)");
    in_out(connect, c.input, c.output, "pairs of poses (docs/stage-formats.md), or -");
    connect->add_option("--radius", c.radius, "least radius; a pair's own R wins");
    connect->add_option("--sharpness", c.sharpness, "largest change of curvature, 1/m^2; default 2.5 / R^2");
    connect->add_option("--style", c.style, "bounded, fair, spiro, bezier or straight")
        ->capture_default_str();
    connect->add_option("--extra-length", c.extra_length, "fair: share of the length that may be spent")
        ->capture_default_str();
    connect->add_flag("--quick", c.quick, "the first good curve instead of the shortest");
    connect->footer("Example:\n  strandline connect pairs.jsonl -o curves.jsonl --radius 0.5m");
    connect->callback([&] { chosen = [&] { return cli::connect(c, common); }; });

    CLI::App* convert = app.add_subcommand("convert", "one stage alone: rake path -> robot path (CSV)");
    in_out(convert, v.input, v.output, "CSV with x,y,pins, or -");
    convert->add_option("--robot", v.robot, "built-in name or profile file")->capture_default_str();
    convert->footer("Example:\n  strandline convert rake.csv --robot beachbot -o robot.csv");
    convert->callback([&] { chosen = [&] { return cli::convert(v, common); }; });
}

}  // namespace strandline::cli
