#include "arguments.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {

int convert(const ConvertArguments& arguments, const Common& common) {
    const auto robot = robot_named(arguments.robot);
    if (!robot) return complain(robot.error(), bad_input);
    const auto text = read_input(arguments.input);
    if (!text) return complain(text.error(), bad_input);
    const auto rows =
        stages::read_rake_csv(*text, arguments.input == "-" ? "stdin" : arguments.input, *robot);
    if (!rows) return complain(rows.error(), bad_input);
    const stages::Conversion conversion = stages::converted(*rows, *robot);
    if (const auto written = write_output(arguments.output, stages::write_robot_csv(conversion)); !written)
        return complain(written.error(), bad_input);
    warn(conversion.undrivable, common.quiet);
    return conversion.undrivable.empty() ? done : falls_short;
}

}  // namespace strandline::cli
