"""Examples that need nobody else: text, files, and the robot at the end."""
import re
import struct

from example import Running


def check_Hello(example):
    example.build()
    with Running(example) as robot:
        robot.wait_for("Hello, world")
        outcome = robot.press_pause()
    example.expect_lines(outcome.lines, example.readme_block(1) + example.readme_block(2))


def check_TalkListen(example):
    example.build()
    example.expect_lines(example.run("--for", "1s").lines, example.readme_block(1))

    config = "MS/OPEN-R/MW/CONF/OBJECT.CFG"
    both = "TALKER.BIN\n/MS/OPEN-R/MW/OBJS/LISTENER.BIN"
    example.replace(config, both, "LISTENER.BIN\n/MS/OPEN-R/MW/OBJS/TALKER.BIN")
    example.expect_lines(example.run("--for", "1s").lines, example.readme_block(1))


def check_ManyToMany(example):
    example.build()
    wanted = example.readme_block(1)
    example.expect_lines(example.run("--for", "1s").lines, wanted)
    for seed in ("2", "3", "4"):
        lines = example.run("--for", "1s", "--seed", seed).lines
        example.expect_lines(sorted(lines), sorted(wanted))
        for name in ("temperature", "pressure", "Recorder"):
            example.expect_lines([line for line in lines if name in line],
                                 [line for line in wanted if name in line])


def check_Lights(example):
    example.build()
    outcome = example.run("--for", "4s")
    example.expect_lines(outcome.lines, example.readme_block(1))
    for locator, state in outcome.report["robots"][0]["leds"].items():
        is_eye = re.search(r"/l[1-6]-LED2:l[1-6]$", locator) and "/r1/" in locator
        example.expect(state == (1 if is_eye else 0), f"{locator} is {state} at the end")
    # The third round begins after two of 768 ms.
    lines = example.run("--for", "1500ms").lines
    example.expect_lines(lines, example.readme_block(1)[:2])


def check_Ears(example):
    example.build()
    example.expect_lines(example.run("--for", "2s").lines, example.readme_block(1))
    # A robot without ears does not load it.
    other = example.run("--for", "1s", "--robot", "ers220", "--body", "ideal")
    example.expect_lines(other.lines, [])


def check_StandUp(example):
    example.build()
    outcome = example.run("--for", "8s")
    example.expect_lines(outcome.lines, example.readme_block(1))
    robot = outcome.report["robots"][0]
    example.expect(robot["standing"], f"the dog does not stand: {robot['base_rpy_deg']}")
    for leg, swing, knee in ((2, -10, 30), (3, 0, 25), (4, -10, 30), (5, 0, 25)):
        for locator, wanted in ((f"PRM:/r{leg}/c1-Joint2:j1", swing),
                                (f"PRM:/r{leg}/c1/c2/c3-Joint2:j3", knee)):
            found = robot["joints_deg"][locator]
            example.expect(abs(found - wanted) < 5, f"{locator} is at {found}, not {wanted}")


def check_Sensors(example):
    example.build()
    lines = example.run("--for", "3s").lines
    wanted = example.readme_block(1)
    example.expect_lines([re.sub(r"-?\d+(\.\d+)?", "N", line) for line in lines],
                         [re.sub(r"-?\d+(\.\d+)?", "N", line) for line in wanted])
    example.expect(lines[0] == wanted[0], f"not '{wanted[0]}' but '{lines[0]}'")
    for line in lines[1:]:
        up, lost = (float(re.search(pattern, line).group(1))
                    for pattern in (r"up (\S+)", r"(\d+) frames lost"))
        example.expect(-11 < up < -8.5, f"standing or lying, gravity is felt: '{line}'")
        example.expect(lost == 0, f"no frame is lost: '{line}'")


def check_PowerMonitor(example):
    example.build()
    example.expect_lines(example.run("--for", "2min", "--body", "ideal").lines,
                         example.readme_block(1))
    with Running(example) as robot:
        robot.wait_for("battery")
        outcome = robot.press_pause()
    example.expect_lines(outcome.lines, example.readme_block(1)[:1] + example.readme_block(2))


def check_Camera(example):
    example.build()
    example.expect_lines(example.run("--for", "2s", "--images", "pattern").lines,
                         example.readme_block(1))
    picture = (example.folder / "MS/OPEN-R/MW/DATA/P/PHOTO.PPM").read_bytes()
    header = b"P6 176 144 255\n"
    if not picture.startswith(header) or len(picture) != len(header) + 3 * 176 * 144:
        example.complaints.append(f"PHOTO.PPM: {picture[:20]}, {len(picture)} bytes")
        return
    # The test pattern: white, yellow, cyan, green, magenta, red, blue, black.
    seen = []
    for bar in range(8):
        at = len(header) + 3 * (176 * 30 + 22 * bar + 11)
        seen.append("".join("01"[value >= 128] for value in picture[at:at + 3]))
    example.expect_lines(seen, ["111", "110", "011", "010", "101", "100", "001", "000"])
    tag_row = picture[len(header) + 3 * 176 * 143:][:3 * 16]
    example.expect(max(tag_row) < 64, "the camera's tag shows in the last row")


def wav(channels, rate, samples):
    data = struct.pack(f"<{len(samples)}h", *samples)
    return (b"RIFF" + struct.pack("<I", 36 + len(data)) + b"WAVEfmt " +
            struct.pack("<IHHIIHH", 16, 1, channels, rate, rate * 2 * channels, 2 * channels, 16) +
            b"data" + struct.pack("<I", len(data)) + data)


def samples_of(content):
    data = content[44:]
    return struct.unpack(f"<{len(data) // 2}h", data)


def check_Tone(example):
    example.build()
    file = example.folder / "speaker.wav"
    speaker = example.flag("--speaker")
    outcome = example.run("--for", "2s", *([speaker, str(file)] if speaker else []))
    example.expect_lines(outcome.lines, example.readme_block(1))
    if not speaker:
        return
    samples = samples_of(file.read_bytes())
    sounding = [i for i, sample in enumerate(samples) if sample != 0]
    if not sounding:
        example.complaints.append("nothing but silence")
        return
    tone = samples[sounding[0] - 1:sounding[-1] + 1]  # a sine begins with 0
    example.expect(len(tone) == 16000, f"{len(tone)} samples instead of a second")
    example.expect(tone[32:] == tone[:-32], "the tone has gaps, or is not of 500 Hz")


def check_Recorder(example):
    example.build()
    heard = example.folder / "heard.wav"
    spoken = [(i * 37) % 2000 - 1000 for i in range(2 * 16000 * 3)]
    heard.write_bytes(wav(2, 16000, spoken))
    microphone = example.flag("--mic")
    outcome = example.run("--for", "2s", *([microphone, str(heard)] if microphone else []))
    example.expect_lines(outcome.lines, example.readme_block(1))
    content = (example.folder / "MS/OPEN-R/MW/DATA/P/RECORD.WAV").read_bytes()
    samples = samples_of(content)
    example.expect(content[:44] == wav(2, 16000, samples)[:44], f"header {content[:44]}")
    example.expect(len(samples) == 2 * 16384, f"{len(samples)} samples")
    if not microphone:
        return
    first = next((i for i in range(0, len(spoken) - len(samples), 2)
                  if tuple(spoken[i:i + len(samples)]) == samples), None)
    example.expect(first is not None, "what was recorded is not what was heard")
