#!/usr/bin/python3
"""Who may include, depend on and say what. Each rule is a function from a source tree to its complaints; each is also
tried on a tree that breaks it."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
GENERATED = {".git", "build", ".deps", "results", "__pycache__"}

# quad_sim <- quad_control <- quad_experiment -> explore_opt, quad_support below all.
MAY_USE = {
    "quad_support": set(),
    "explore_opt": {"quad_support"},
    "quad_sim": {"quad_support"},
    "quad_control": {"quad_support", "quad_sim"},
    "quad_experiment": {"quad_support", "quad_sim", "quad_control", "explore_opt"},
    "quad_tests": {"quad_support", "quad_sim", "quad_control", "explore_opt", "quad_experiment"},
}
NO_ROS_AT_ALL = {"quad_support", "explore_opt"}
ROS_HEADER = re.compile(r"(ros|roscpp|rosconsole|rosbag|rosgraph|xmlrpcpp|tf2?(_\w+)?|\w+_msgs|std_srvs|rotors_comm|urdf|"
                        r"message_filters|nodelet|pluginlib|class_loader|actionlib|dynamic_reconfigure|topic_tools)/")
ONE_FILE_EACH = {
    "ODE": re.compile(r"ode/"),
    "Ipopt": re.compile(r"(coin/|coin-or/)?Ip[A-Z]\w*\.hpp$"),
    "urdfdom": re.compile(r"urdf_(parser|model|world|exception|model_state|sensor)/"),
    "yaml-cpp": re.compile(r"yaml-cpp/"),
    "rosbag": re.compile(r"rosbag/"),
}
PACKAGE_OF = {"rosbag/bag.h": "rosbag_storage"}  # where the folder does not say
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
MACHINE_PATH = re.compile(r"(?<![\w.}$)])/(?:home|root|work|Users|mnt|media)/[\w.]")
DEPENDENCY_TAGS = ("depend", "build_depend", "build_export_depend", "exec_depend", "run_depend", "test_depend")


def tracked(root):
    """What git knows of; None where it cannot be asked. A log that somebody leaves in the tree is not ours."""
    if not os.path.exists(os.path.join(root, ".git")):
        return None
    answer = subprocess.run(["git", "-C", root, "ls-files", "-z"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return set(os.fsdecode(answer.stdout).split("\0")) if answer.returncode == 0 else None


def files(root, suffixes=None):
    """Paths below root, relative to it, of the text we wrote."""
    known = tracked(root)
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(d for d in folders if d not in GENERATED and not os.path.islink(os.path.join(folder, d)))
        for name in sorted(names):
            path = os.path.join(folder, name)
            if name in GENERATED or os.path.islink(path) or not (suffixes is None or name.endswith(suffixes)):
                continue
            if known is None or os.path.relpath(path, root) in known:
                yield os.path.relpath(path, root)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8", errors="replace") as file:
        return file.read()


def includes(root):
    """(path, package, header) of every #include in the packages."""
    for path in files(root, (".cpp", ".hpp", ".h", ".cc", ".ipp")):
        package = package_of(path)
        if package:
            for header in INCLUDE.findall(read(root, path)):
                yield path, package, header


def package_of(path):
    parts = path.split(os.sep)
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
    return "quad_tests" if parts[0] == "test" else None


def is_test(path):
    return bool({"test", "tests", "bench", "benchmark"} & set(path.split(os.sep)[:-1]))


def generated_headers(root):
    """Headers that message generation makes of the workspace's own .msg and .srv files."""
    return {"%s/%s.h" % (package_of(path), os.path.splitext(os.path.basename(path))[0])
            for path in files(root, (".msg", ".srv"))}


def is_ros(header, generated):
    return header in generated or bool(ROS_HEADER.match(header))


def ros_outside_its_layer(root):
    generated = generated_headers(root)
    for path, package, header in includes(root):
        in_layer = path.startswith(os.path.join("src", package, "src", "ros") + os.sep)
        if is_ros(header, generated) and (package in NO_ROS_AT_ALL or not (in_layer or is_test(path))):
            yield "%s: includes <%s>; only files in src/%s/src/ros/ may include a ROS header" % (path, header, package)


def library_in_two_files(root):
    for library, pattern in ONE_FILE_EACH.items():
        users = {}
        for path, package, header in includes(root):
            if pattern.match(header) and not is_test(path):
                users.setdefault(package, set()).add(path)
        for package, paths in sorted(users.items()):
            # A header of the package's own, which nobody outside sees, is as good: replacing the library still begins there.
            inside = os.path.join("src", package, "src") + os.sep
            if len(paths) > 1 or not all(p.startswith(inside) for p in paths):
                yield "%s: %s is included by %s; one file below %s may" % (package, library, ", ".join(sorted(paths)), inside)


def arrows_backwards(root):
    for path, package, header in includes(root):
        used = header.split("/")[0]
        if used in MAY_USE and used != package and used not in MAY_USE.get(package, set()):
            yield "%s: %s may not use %s" % (path, package, used)
    for package, (path, dependencies) in manifests(root).items():
        for used in sorted(dependencies & set(MAY_USE) - {package} - MAY_USE.get(package, set())):
            yield "%s: %s may not depend on %s" % (path, package, used)
        if package in NO_ROS_AT_ALL:
            for used in sorted(d for d in dependencies if ROS_HEADER.match(d + "/") or d == "rospy"):
                yield "%s: %s knows no ROS but depends on %s" % (path, package, used)


def manifests(root):
    """{package: (path of package.xml, names it depends on)}"""
    found = {}
    for path in files(root, ("package.xml",)):
        tree = ElementTree.parse(os.path.join(root, path)).getroot()
        found[tree.findtext("name")] = (path, {e.text.strip() for tag in DEPENDENCY_TAGS for e in tree.findall(tag)})
    return found


def dependencies_disagree(root):
    """package.xml, CMakeLists.txt and #include tell the same story about the workspace's and ROS's packages."""
    generated = generated_headers(root)
    known = manifests(root)
    for package, (manifest, declared) in known.items():
        folder = os.path.dirname(manifest)
        cmake_path = os.path.join(folder, "CMakeLists.txt")
        cmake = re.sub(r"#.*", "", read(root, cmake_path)) if os.path.exists(os.path.join(root, cmake_path)) else ""
        components = set()
        for call in re.findall(r"find_package\s*\(\s*catkin\s+REQUIRED\s+COMPONENTS([^)]*)\)", cmake):
            components |= set(call.split())
        for name in sorted(components - declared):
            yield "%s: finds %s, which %s does not declare" % (cmake_path, name, manifest)
        for path, owner, header in includes(root):
            used = PACKAGE_OF.get(header, header.split("/")[0])
            if owner != package or "/" not in header or used == package:
                continue
            if (used in known or is_ros(header, generated)) and used != "ros" and used not in declared:
                yield "%s: includes <%s>, but %s does not declare %s" % (path, header, manifest, used)
            if used == "ros" and "roscpp" not in declared:
                yield "%s: includes <%s>, but %s does not declare roscpp" % (path, header, manifest)
        ours = {d for d in declared if d in known or re.fullmatch(r"roscpp|\w+_msgs|std_srvs|tf2\w*", d)}
        runtime = {e.text.strip() for e in ElementTree.parse(os.path.join(root, manifest)).getroot().findall("exec_depend")}
        for name in sorted(ours - runtime - components):
            if not re.search(r"\b%s\b" % re.escape(name), cmake):
                yield "%s: declares %s, which %s does not use" % (manifest, name, cmake_path)


def env_python(root):
    for path in files(root):
        if re.match(r"#! ?/usr/bin/env +python", read(root, path)):
            yield "%s: starts with env python; say #!/usr/bin/python3, the one that sees ROS's packages" % path


def machine_paths(root):
    for path in files(root):
        with open(os.path.join(root, path), "rb") as file:
            data = file.read()
        if b"\0" in data:
            continue
        for number, line in enumerate(data.decode(errors="replace").splitlines(), 1):
            if MACHINE_PATH.search(line):
                yield "%s:%d: names a folder of one machine: %s" % (path, number, MACHINE_PATH.search(line).group(0))


RULES = (ros_outside_its_layer, library_in_two_files, arrows_backwards, dependencies_disagree, env_python, machine_paths)


def manifest(name, *dependencies):
    return "<package format='2'><name>%s</name>%s</package>" % (
        name, "".join("<depend>%s</depend>" % d for d in dependencies))


class ThisTree(unittest.TestCase):
    maxDiff = None

    def test_keeps_every_rule(self):
        for rule in RULES:
            with self.subTest(rule.__name__):
                self.assertEqual(list(rule(ROOT)), [])

    def test_is_looked_at(self):
        self.assertGreater(len(list(includes(ROOT))), 50)
        self.assertIn("quad_support", manifests(ROOT))


class EachRuleCatches(unittest.TestCase):
    def complaints(self, rule, **tree):
        with tempfile.TemporaryDirectory() as root:
            for path, content in tree["tree"].items():
                os.makedirs(os.path.dirname(os.path.join(root, path)) or root, exist_ok=True)
                with open(os.path.join(root, path), "w") as file:
                    file.write(content)
            return len(list(rule(root)))

    def check(self, rule, good, bad):
        self.assertEqual(self.complaints(rule, tree=good), 0, "complains about what is right")
        self.assertEqual(self.complaints(rule, tree=bad), len(bad), "misses something")

    def test_ros_outside_its_layer(self):
        self.check(ros_outside_its_layer,
                   {"src/quad_sim/src/ros/node.cpp": "#include <ros/ros.h>\n#include <quad_sim/Step.h>\n",
                    "src/quad_sim/test/test_node.cpp": "#include <ros/ros.h>\n",
                    "src/quad_sim/src/a.cpp": "// #include <ros/ros.h>\n#include <rosy.h>\n"},
                   {"src/quad_sim/src/a.cpp": "#include <ros/ros.h>\n",
                    "src/quad_sim/include/quad_sim/a.hpp": '# include "nav_msgs/Odometry.h"\n',
                    "src/explore_opt/src/ros/a.cpp": "#include <std_msgs/String.h>\n"})

    def test_generated_header_counts_as_ros(self):
        tree = {"src/quad_sim/srv/Step.srv": "---\n", "src/quad_sim/src/a.cpp": "#include <quad_sim/Step.h>\n"}
        self.assertEqual(self.complaints(ros_outside_its_layer, tree=tree), 1)

    def test_library_in_two_files(self):
        self.check(library_in_two_files,
                   {"src/quad_sim/src/a.hpp": "#include <ode/ode.h>\n", "src/quad_sim/test/t.cpp": "#include <ode/ode.h>\n",
                    "src/explore_opt/src/a.cpp": "#include <IpTNLP.hpp>\n#include <IpIpoptApplication.hpp>\n"},
                   {"src/quad_sim/include/quad_sim/a.hpp": "#include <urdf_model/model.h>\n"})
        two = {"src/quad_sim/src/%s.cpp" % name: "#include <ode/ode.h>\n" for name in "ab"}
        self.assertEqual(self.complaints(library_in_two_files, tree=two), 1)

    def test_arrows_backwards(self):
        self.check(arrows_backwards,
                   {"src/quad_control/src/a.cpp": "#include <quad_sim/vehicle.hpp>\n",
                    "src/explore_opt/package.xml": manifest("explore_opt", "quad_support", "fmt")},
                   {"src/quad_sim/src/a.cpp": "#include <quad_control/pi.hpp>\n",
                    "src/explore_opt/src/a.cpp": "#include <quad_sim/vehicle.hpp>\n",
                    "src/explore_opt/package.xml": manifest("explore_opt", "std_msgs"),
                    "src/quad_control/package.xml": manifest("quad_control", "quad_experiment")})

    def test_dependencies_disagree(self):
        cmake = "find_package(catkin REQUIRED COMPONENTS %s)"
        self.check(dependencies_disagree,
                   {"src/quad_sim/package.xml": manifest("quad_sim", "roscpp", "nav_msgs"),
                    "src/quad_sim/CMakeLists.txt": cmake % "roscpp nav_msgs",
                    "src/quad_sim/src/ros/a.cpp": "#include <ros/ros.h>\n#include <nav_msgs/Odometry.h>\n"}, {})
        for bad in ({"src/quad_sim/package.xml": manifest("quad_sim"), "src/quad_sim/CMakeLists.txt": cmake % "roscpp"},
                    {"src/quad_sim/package.xml": manifest("quad_sim", "roscpp"),
                     "src/quad_sim/CMakeLists.txt": cmake % "" + " # roscpp"},
                    {"src/quad_sim/package.xml": manifest("quad_sim"),
                     "src/quad_sim/src/ros/a.cpp": "#include <nav_msgs/Odometry.h>\n"}):
            self.assertEqual(self.complaints(dependencies_disagree, tree=bad), 1, bad)

    def test_env_python(self):
        self.check(env_python, {"scripts/a": "#!/usr/bin/python3\n", "b.sh": "#!/usr/bin/env bash\n"},
                   {"scripts/a": "#!/usr/bin/env " + "python3\n", "b": "#! /usr/bin/env " + "python\n"})

    def test_what_git_does_not_know_is_left_alone(self):
        with tempfile.TemporaryDirectory() as root:
            for name in ("ours.md", "make.log"):
                with open(os.path.join(root, name), "w") as file:
                    file.write("see /" + "home/somebody/x\n")
            self.assertEqual(len(list(machine_paths(root))), 2)
            for words in (["init", "-q"], ["add", "ours.md"]):
                subprocess.run(["git", "-C", root] + words, check=True)
            self.assertEqual(list(files(root)), ["ours.md"])
            self.assertEqual(len(list(machine_paths(root))), 1)

    def test_machine_paths(self):
        self.check(machine_paths, {"a.md": "see ~/x, ${X}/root/x, http://a.b/home/x, /usr/bin, results/work/x"},
                   {"a.md": "in /" + "home/jane", "b.sh": "cd /" + "root/.ros", "c.yaml": "urdf: /" + "work/x.urdf"})


if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:    # of this tree, or of another
        found = [complaint for rule in RULES for complaint in rule((sys.argv[2:] or [ROOT])[0])]
        print("\n".join(found))
        sys.exit(bool(found))
    unittest.main()
