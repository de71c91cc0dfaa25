"""What `copier update` does to a developer's package: merge, prove, put in place.

    update       the order of all that follows
    preflight    refuses what git could not bring back, before the first write
    transaction  takes a snapshot, puts a result in place, or brings the snapshot back
    render       the old and the new version, from recorded answers
    renaming     which identifiers, paths and keys a rename exchanges; moves, those of a model
    package      three versions of a package merged file by file
    merging      three versions of a file merged by block, lines inside of a block
    languages    what a file consists of: blocks of Python, C++, XML, YAML, CMake, Markdown
    proof        reads every line of the developer's back
    report       says what became of the files

A render needs nothing of this.
"""
