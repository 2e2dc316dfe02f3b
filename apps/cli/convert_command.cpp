#include "arguments.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "result/stages/stages.hpp"

namespace strandline::cli {

int convert(const ConvertArguments& arguments, const Common& common) {
    const auto robot = robot_named(arguments.robot);
    if (!robot) {
        complain(robot.error());
        return bad_input;
    }
    const auto text = read_input(arguments.input);
    if (!text) {
        complain(text.error());
        return bad_input;
    }
    const auto rows = stages::read_rake_csv(*text, arguments.input == "-" ? "stdin" : arguments.input);
    if (!rows) {
        complain(rows.error());
        return bad_input;
    }
    const stages::Conversion conversion = stages::converted(*rows, *robot);
    if (const auto written = write_output(arguments.output, stages::write_robot_csv(conversion)); !written) {
        complain(written.error());
        return bad_input;
    }
    warn(conversion.undrivable, common.quiet);
    return conversion.undrivable.empty() ? done : falls_short;
}

}  // namespace strandline::cli
