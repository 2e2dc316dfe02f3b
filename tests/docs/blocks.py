#!/usr/bin/python3
"""blocks.py PROGRAM PAGE.md: runs every code block of a page, in order, in one new folder where drawings/ lies as in the repository.

A block is fenced or indented by four. What stands before it says what it is:
    (nothing)                      commands: run by bash, all must end with 0
    <!-- file: robot.toml -->      text that is written to that file
    <!-- ends with 3 -->           commands; the last one ends so
    <!-- shown: what it is -->     no commands: output, a template, a piece of a file
    <!-- not run: why -->          commands that cannot run here
`./run ARGS` and `strandline ARGS` are the program. `serve` is started on a free port, its page fetched, and stopped. A photo.jpg is there, and tests/docs/web
in the place of the editor's pages.
"""
import os, re, shlex, signal, subprocess, sys, tempfile, time, urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MARK = re.compile(r"<!-- (file|ends with|shown|not run): ?(.*?) ?-->|<!-- (ends with) (\d+) -->")
SERVE = re.compile(r"(?:\./run|strandline) serve\b")


def blocks(text):
    """-> (line number, mark, its value, text) of each block"""
    lines, found, mark, k = text.split("\n"), [], (None, ""), 0
    while k < len(lines):
        line = lines[k]
        if match := MARK.fullmatch(line.strip()):
            mark, k = (match[1] or match[3], match[2] or match[4]), k + 1
            continue
        fenced = line.startswith("```")
        if fenced or (line.startswith("    ") and line.strip() and stands_alone(lines, k)):
            begin, body = k + 1, []
            k += 1 if fenced else 0
            while k < len(lines) and (not lines[k].startswith("```") if fenced else lines[k].startswith("    ") or not lines[k].strip()):
                body.append(lines[k] if fenced else lines[k][4:])
                k += 1
            k += 1 if fenced else 0
            found.append((begin, *mark, "\n".join(body).rstrip() + "\n"))
            mark = (None, "")
            continue
        if line.strip(): mark = (None, "")
        k += 1
    return found


def stands_alone(lines, k):
    """whether an indented line begins a block: below an empty line or a heading that no list goes on through"""
    if lines[k - 1].startswith("#") or k == 0: return True
    if lines[k - 1].strip(): return MARK.fullmatch(lines[k - 1].strip()) is not None
    above = next((line for line in reversed(lines[:k]) if line.strip()), "")
    return not re.match(r"\s*(?:[-*]|\d+\.) |  \S", above)


def served(command, folder, environment):
    """starts the editor, fetches its page, stops it; -> what went wrong, or nothing"""
    arguments = [*shlex.split(command, comments=True), "--web", str(ROOT / "tests/docs/web")]
    if "--port" not in arguments: arguments += ["--port", "0"]
    server = subprocess.Popen(arguments, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        said = server.stdout.readline()
        if not (address := re.search(r"http://\S+", said)): return f"no address: {said}{server.stdout.read()}"
        with urllib.request.urlopen(address[0].replace("localhost", "127.0.0.1"), timeout=20) as answer:
            return "" if b"Strandline" in answer.read() else "the page is another"
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(20)


def prepared(program, folder):
    (folder / "drawings").symlink_to(ROOT / "drawings")
    for name in ("run", "strandline"): (folder / name).symlink_to(program)
    plan = folder / "photo.json"
    subprocess.run([program, "-q", "plan", ROOT / "drawings/hello.svg", "-o", plan], check=True)
    subprocess.run([program, "-q", "render", plan, "-o", folder / "photo.png", "--pixels", "300"], check=True)
    (folder / "photo.png").rename(folder / "photo.jpg")  # what it is, its first bytes say
    plan.unlink()
    return os.environ | {"PATH": f"{folder}:{os.environ['PATH']}", "HOME": str(folder)}


def main(program, page):
    faults, ran = [], 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        environment = prepared(program, folder)
        for line, mark, value, text in blocks(page.read_text()):
            began = time.monotonic()
            if mark == "file":
                (folder / value).write_text(text)
                continue
            if mark in ("shown", "not run"): continue
            servers = [command for command in text.split("\n") if SERVE.search(command)]
            for command in servers:
                if wrong := served(command, folder, environment): faults.append(f"{page.name}:{line}: {command}: {wrong}")
            commands = "\n".join(command for command in text.split("\n") if command not in servers)
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
            ran += 1
            print(f"{page.name}:{line}: {time.monotonic() - began:.1f} s, exit {done.returncode}", flush=True)
            if done.returncode != int(value if mark == "ends with" else 0):
                faults.append(f"{page.name}:{line}: exit {done.returncode}\n{text}{done.stdout[-1500:]}{done.stderr[-1500:]}")
    if not ran: faults.append(f"{page.name}: no block was run")
    for fault in faults: print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), Path(sys.argv[2])))
