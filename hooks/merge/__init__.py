"""What `copier update` does to a developer's package: merge, prove, put in place.

preflight   refuses what git could not bring back, before the first write
renders     the old and the new render, from recorded answers
renaming    which identifiers and paths a rename exchanges
blocks      a file as callbacks, elements, keys; one module for each language
merging     three versions of a file merged by block, inside of a block by line
package     three versions of a package merged file by file
proof       reads every line of the developer's back
transaction takes a snapshot, puts a result in place, or brings the snapshot back
update      the order of all that
"""
