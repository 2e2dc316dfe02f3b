"""What every section of the bench needs: running the program, and tables."""
import resource, subprocess, sys, tempfile


def run(arguments, stdin=None, timeout=600):
    """-> (exit code, stdout, stderr, CPU seconds, peak MB); exit code None after the timeout"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen([str(a) for a in arguments], stdin=subprocess.PIPE if stdin is not None else subprocess.DEVNULL,
                                   stdout=out, stderr=err)
        try:
            process.communicate(stdin.encode() if stdin is not None else None, timeout=timeout)
            code = process.returncode
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            code = None
        out.seek(0), err.seek(0)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return code, out.read().decode(errors="replace"), err.read().decode(errors="replace"), cpu, after.ru_maxrss / 1024


def peak_mb(arguments):
    """of this one process, not of all children so far"""
    script = "import resource,subprocess,sys; subprocess.run(sys.argv[1:],stdout=subprocess.DEVNULL,stderr=subprocess.DEVNULL); print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss/1024)"
    return float(subprocess.run([sys.executable, "-c", script, *map(str, arguments)], capture_output=True, text=True).stdout)


def table(title, head, rows):
    print(f"\n## {title}\n")
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(str(c) for c in row) + " |")
    sys.stdout.flush()


def percent(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * (len(values) - 1) + 0.5))] if values else float("nan")
