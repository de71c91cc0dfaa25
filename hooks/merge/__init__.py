"""What `copier update` does to a developer's package: merge, prove, put in place.

    update       the order of all that follows
    preflight    refuses what git could not bring back, before the first write
    transaction  takes a snapshot, puts the result in place, or restores the snapshot
    render       renders the old and the new version
    renaming     which identifiers, paths and keys a rename exchanges; tokens, the words of code;
                 origins, where these come from
    depth        the keys of YAML that another ROS puts below others
    indentation  the model's versions, indented as the developer's
    launch       what the developer wrote into a launch file, carried into that of another ROS
    builds       the same for CMakeLists.txt and setup.py
    branches     two branches, each brought to the merged spec, become one
    versions     three versions of a package, their merge and its proofs
    moves        the files that a new version of the model renames
    package      three versions of a package merged file by file
    merging      three versions of a file merged by block, lines inside of a block
    matching     which block is which, wherever the developer has put it
    lines        three lists of lines merged
    languages    what a file consists of: blocks of Python, C++, XML, YAML, CMake, Markdown
    proof        finds every line of the developer again
    recount      the second proof: counts all lines, without the blocks and their matching
    uses         finds where the developer's lines use what was renamed, or left
    report       says what became of the files
    tree, git    files in memory; git

Only an update and a recopy import this.
"""
