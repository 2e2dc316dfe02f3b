#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App app{"A drawing becomes one drivable path for a drawing robot"};
    app.set_version_flag("--version", "strandline " STRANDLINE_VERSION);
    CLI11_PARSE(app, argc, argv);
    return 0;
}
